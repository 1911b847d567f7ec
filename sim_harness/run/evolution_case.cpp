// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/evolution_case.hpp"

#include <algorithm>
#include <sstream>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kRounding_m = 1e-6;
constexpr double kLeastShare = 0.5;  // of the way of a gate, that of its plane

void check_reach(const YamlReader& in, const PlaneLayout& layout, const WindDemand& lidar) {
  for (const GateCentre& centre : lidar.gates) {
    const double distance_m = -centre.position_I_m.x;
    if (distance_m <= layout.reach_m() + kRounding_m) continue;
    std::ostringstream text;
    text << "beam " << centre.beam << ", gate " << centre.gate << " of the lidar is centred "
         << distance_m << " m up-wind; planes up to " << layout.last_m() << " m reach to "
         << layout.reach_m()
         << " m, half a distance of planes further: add planes, or leave the key out to have one "
            "at each gate";
    in.fail("planes_m", text.str());
  }
}

/// A gate whose nearest plane is at the rotor, or close to it, would see wind that hardly evolves.
void check_nearness(const YamlReader& in, const PlaneLayout& layout, const WindDemand& lidar) {
  for (const GateCentre& centre : lidar.gates) {
    const double distance_m = -centre.position_I_m.x;
    const double plane_m = layout.distance_m(layout.nearest(distance_m));
    if (distance_m <= 0.0 || plane_m >= kLeastShare * distance_m) continue;
    std::ostringstream text;
    text << "beam " << centre.beam << ", gate " << centre.gate << " of the lidar is centred "
         << distance_m << " m up-wind; the nearest plane, at " << plane_m
         << (plane_m > 0.0 ? " m" : " m, the rotor's own")
         << ", would give it wind that evolves over less than half of its way: add planes near the "
            "gate, or leave the key out to have one at each gate";
    in.fail("planes_m", text.str());
  }
}

template <class Planes>
void make_each(Planes planes, const std::vector<double>& planes_m, const FlowShape& shape,
               const TakePlane& take) {
  const auto make = [&](double distance_m) {
    VelocityGrid grid = planes.next(distance_m).take_grid();
    apply(shape, grid);
    take(distance_m, GriddedWind(std::move(grid)));
  };
  make(0.0);
  for (const double distance_m : planes_m) make(distance_m);
}

}  // namespace

std::vector<double> read_planes(YamlReader& in, const WindSurroundings& around) {
  if (!in.has("planes_m")) {
    if (!around.lidar || around.lidar->gates.empty()) {
      in.fail("planes_m",
              "missing: expected distances from the rotor [m], or a lidar whose gates say them");
    }
    return planes_at_gates(*around.lidar);
  }
  std::vector<double> planes_m = in.numbers("planes_m", Range::positive());
  if (std::ranges::adjacent_find(planes_m, std::ranges::greater_equal{}) != planes_m.end())
    in.fail("planes_m", "expected distances that rise");
  if (around.lidar) {
    const PlaneLayout layout(planes_m);
    check_reach(in, layout, *around.lidar);
    check_nearness(in, layout, *around.lidar);
  }
  return planes_m;
}

std::unique_ptr<WindField> shaped(EvolvingGrids grids, const FlowShape& shape) {
  apply(shape, grids.rotor);
  for (ThinnedGrid& grid : grids.upwind) apply(shape, grid);
  return std::make_unique<EvolvingWind>(std::move(grids));
}

void make_planes(const WindCase& wind, const TakePlane& take) {
  if (!evolves(wind)) throw Error("planes up-wind: expected wind with the key evolution");
  if (wind.direction.turns())
    throw Error("planes up-wind: expected wind without yaw_deg and upflow_deg, which tilt planes");
  if (const auto* mann = std::get_if<MannWind>(&wind.source)) {
    make_each(MannPlanes(mann->field), mann->planes_m, wind.shape, take);
  } else {
    const auto& kaimal = std::get<KaimalWind>(wind.source);
    make_each(KaimalPlanes(kaimal.field), kaimal.planes_m, wind.shape, take);
  }
}

WindDemand turned(const WindDemand& demand, const WindCase& wind) {
  const WindAxes axes(wind.hub_height_m, wind.direction);
  WindDemand in_field{{}, demand.points_I_m, std::max(demand.margin_m, kDiskRaster_m)};
  for (const DiskPoint& p :
       disk_raster(wind.hub_height_m, wind.rotor_radius_m + kDiskRaster_m, kDiskRaster_m))
    in_field.points_I_m.push_back({0.0, p.y_m, p.z_m});
  for (Vec3& point : in_field.points_I_m) point = axes.place_in_field(point);
  return in_field;
}

}  // namespace lac::sim
