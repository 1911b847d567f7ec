// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "sim_harness/lidar/beam_extent.hpp"
#include "sim_harness/lidar/spinner_positions.hpp"

namespace lac::sim {
namespace {

std::vector<GateCentre> centres_of(const std::vector<BeamSamples>& beams, const LidarPose& pose) {
  std::vector<GateCentre> centres;
  for (std::size_t b = 0; b < beams.size(); ++b) {
    const Vec3 dir_I = pose.R_IL * beams[b].dir_L;
    for (std::size_t g = 0; g < beams[b].gates.size(); ++g) {
      centres.push_back({static_cast<int>(b) + 1, static_cast<int>(g) + 1,
                         pose.position_I_m + beams[b].gates[g].range_m * dir_I});
    }
  }
  return centres;
}

}  // namespace

WindDemand wind_demand(const LidarParams& lidar, double hub_height_m) {
  const Mounting mounting(lidar.mounting, lidar.platform, hub_height_m);
  const Mounting on_land(lidar.mounting, {}, hub_height_m);
  const std::vector<BeamSamples> beams = make_beam_samples(lidar);
  WindDemand demand{centres_of(beams, mounting.rest_pose()), {}, 0.0};
  double farthest_m = 0.0, radius_m = 0.0;
  for (const double tower_x_m : mounting.tower_positions_m()) {
    for (const double azimuth_rad : looked_at_azimuths(mounting)) {
      const LidarPose pose =
          on_land.pose({.tower_x_m = tower_x_m, .azimuth_rad = azimuth_rad}, 0.0);
      for (const BeamSamples& beam : beams) {
        const Vec3 dir_I = pose.R_IL * beam.dir_L;
        for (const double range_m : beam.points_m) {
          demand.points_I_m.push_back(pose.position_I_m + range_m * dir_I);
          const Vec3& p = demand.points_I_m.back();
          radius_m = std::max(radius_m, std::hypot(p.y, p.z - hub_height_m));
          farthest_m = std::max(farthest_m, range_m);
        }
      }
    }
  }
  demand.margin_m = mounting.greatest_travel_m(farthest_m);
  if (mounting.turns_with_rotor()) demand.margin_m += radius_m * kPi / kSpinnerPositions;
  return demand;
}

}  // namespace lac::sim
