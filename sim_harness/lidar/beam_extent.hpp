// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/lidar/beam_samples.hpp"
#include "sim_harness/lidar/mounting.hpp"
#include "sim_harness/wind/wind_demand.hpp"
#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

/// Where a lidar will ask for the wind, and how far motion may take these places: gate centres
/// and every point of every gate, nacelle at rest; a spinner in all its positions.
WindDemand wind_demand(const LidarParams& lidar, double hub_height_m);

/// Whether beams stay where there is wind. All functions throw lac::Error that names beam, gate,
/// place and by how far; with motion also the time.
class BeamExtent {
 public:
  BeamExtent(const std::vector<BeamSamples>& beams, const Mounting& mounting,
             const WindField& field);

  /// At rest: a gate behind the rotor plane, a volume that reaches behind the lidar, into the
  /// ground or to a place that the field has not kept.
  void check_at_rest() const;
  /// Some beams at this time, moved as far as can be known before the run: by the platform, by a
  /// spinner in all its positions; the tower top at rest, kTowerTravel_m earlier or later in time.
  void check_planned(std::size_t first_beam, std::size_t count, double time_s) const;
  /// One beam as it is.
  void check_now(std::size_t beam, const LidarPose& pose, double time_s) const {
    check_beam(beam, pose, time_s, 0.0);
  }

 private:
  bool is_inside(const Vec3& point_I_m, double time_s, double travel_m) const;
  void check_gate_at_rest(std::size_t beam, std::size_t gate, const LidarPose& pose) const;
  void check_beam(std::size_t beam, const LidarPose& pose, double time_s, double travel_m) const;
  void report(std::size_t beam, const LidarPose& pose, double time_s, double travel_m) const;

  const std::vector<BeamSamples>& beams_;
  const Mounting& mounting_;
  const WindField& field_;
  WindExtent extent_;
  std::vector<double> nearest_m_;
  std::vector<double> farthest_m_;
};

}  // namespace lac::sim
