// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

/// Mean wind that does not blow along the rotor axis.
struct FlowDirection {
  /// Yaw misalignment: the wind turned clockwise seen from above, it blows towards -y (to the
  /// right) where positive; the direction of uniform wind files and InflowWind's PropagationDir.
  double yaw_rad = 0.0;
  /// Inclination: the wind blows upwards where positive (InflowWind's VFlowAng).
  double upflow_rad = 0.0;
  /// How far up-wind of the rotor the field is asked for (and, in a field without sides, how far
  /// beside its axis); the extent counts on it.
  double reach_m = 250.0;

  bool turns() const { return yaw_rad != 0.0 || upflow_rad != 0.0; }
};

/// A field turned as a whole about the rotor centre (0, 0, hub height): a wind frame W with
/// e_x = (cos yaw cos up, -sin yaw cos up, sin up) in I, e_y horizontal. Positions are taken
/// into W, the velocity found there is taken back; so the pattern travels along the inclined mean
/// wind, and a beam straight ahead looks past the air that will meet the rotor.
///
/// mean_speed_mps() is that along x, U cos yaw cos up. extent() holds for points from the rotor to
/// reach_m up-wind and is smaller than the field's own; where the field begins at a time, its first
/// part is passed over so that time 0 is whole at the rotor plane.
class TurnedWind final : public WindField {
 public:
  /// Throws lac::Error if an angle is 80 deg or more, or no room is left in the field.
  TurnedWind(std::unique_ptr<const WindField> field, double hub_height_m,
             const FlowDirection& direction);

  Vec3 velocity(const Vec3& position_I_m, double time_s) const override;
  double mean_speed_mps() const override { return field_->mean_speed_mps() * axis_x_I_.x; }
  WindExtent extent() const override { return extent_; }
  /// The field's own points; the raster where it has but one, since the rotor cuts through planes.
  std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const override;

 private:
  void set_extent(double reach_m);

  std::unique_ptr<const WindField> field_;
  double hub_height_m_;
  Vec3 axis_x_I_, axis_y_I_, axis_z_I_;  // of W
  double delay_s_ = 0.0;                 // what is passed over
  WindExtent extent_;
};

}  // namespace lac::sim
