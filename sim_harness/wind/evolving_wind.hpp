// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/wind/evolving_grids.hpp"
#include "sim_harness/wind/gridded_wind.hpp"

namespace lac::sim {

/// Turbulence that changes on its way to the rotor: gridded fields at some distances, each like
/// the one before but for what has decayed and grown between them.
///
/// velocity() at x is that of the plane nearest to -x, carried to x with Taylor's hypothesis over
/// arrival times: velocity(x, y, z, t) = plane(-x).velocity(x, y, z, t). At every x the one-point
/// and the yz statistics are exactly those of one plane; the longitudinal coherence is exact
/// between the planes themselves and a staircase in between. (Mixing two neighbours would be
/// smooth, and take variance out between them.) Put planes at the gates of the lidar: a gate then
/// reads its own plane, and with gates close to each other the ends of its probe volume read the
/// neighbours'.
///
/// Up-wind the field holds() what was demanded; asked elsewhere, velocity() throws lac::Error.
class EvolvingWind final : public WindField {
 public:
  /// Throws lac::Error unless there is one grid per plane, all of one GridSpec.
  explicit EvolvingWind(EvolvingGrids grids);

  Vec3 velocity(const Vec3& position_I_m, double time_s) const override;
  double mean_speed_mps() const override { return rotor_.mean_speed_mps(); }
  WindExtent extent() const override { return rotor_.extent(); }
  double period_s() const override { return rotor_.period_s(); }
  bool holds(const Vec3& position_I_m) const override;
  std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const override {
    return rotor_.disk_points(hub_height_m, radius_m);
  }

  const PlaneLayout& layout() const { return layout_; }
  const GriddedWind& rotor_plane() const { return rotor_; }
  /// Numbers of plane 1, 2, ...
  const ThinnedGrid& upwind_plane(std::size_t plane) const { return upwind_[plane - 1]; }

 private:
  PlaneLayout layout_;
  GriddedWind rotor_;
  std::vector<ThinnedGrid> upwind_;
  GridLocator locator_;
};

}  // namespace lac::sim
