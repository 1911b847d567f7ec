// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "sim_harness/wind/grid_interpolation.hpp"
#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

/// A field given on a regular y-z grid over time: bilinear in y and z, linear in t, in single
/// precision; x by Taylor's hypothesis. t = 0 is the first plane passing the rotor plane x = 0.
///
/// Linear interpolation takes variance out between grid points, most of all where neighbouring
/// points are independent (in the middle of a cell three quarters of it).
///
/// Outside extent() the value at the nearest border is returned, so that memory is safe whatever
/// is asked; it is no meaningful wind, callers check their points and times once at set-up.
/// A periodic field has no bounds in time.
class GriddedWind final : public WindField {
 public:
  explicit GriddedWind(VelocityGrid grid);

  Vec3 velocity(const Vec3& position_I_m, double time_s) const override;
  double mean_speed_mps() const override { return grid_.spec().mean_speed_mps; }
  WindExtent extent() const override;
  double period_s() const override;
  /// The grid points within the radius, the rim included.
  std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const override;

  /// The period nt dt if periodic, else the time between first and last plane.
  double duration_s() const;
  const VelocityGrid& grid() const { return grid_; }
  VelocityGrid take_grid() && { return std::move(grid_); }

 private:
  VelocityGrid grid_;
  GridLocator locator_;
};

}  // namespace lac::sim
