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

/// Frame W of a wind turned about the rotor centre: e_x = (cos yaw cos up, -sin yaw cos up, sin up)
/// in I, e_y horizontal.
class WindAxes {
 public:
  WindAxes(double hub_height_m, const FlowDirection& direction);

  /// The place in a field that is not turned.
  Vec3 place_in_field(const Vec3& position_I_m) const {
    const Vec3 from_hub = position_I_m - Vec3{0.0, 0.0, hub_height_m_};
    return {dot(x_I_, from_hub), dot(y_I_, from_hub), dot(z_I_, from_hub) + hub_height_m_};
  }
  /// A velocity found there, in I.
  Vec3 turned(const Vec3& v) const { return v.x * x_I_ + v.y * y_I_ + v.z * z_I_; }

  double hub_height_m() const { return hub_height_m_; }
  const Vec3& x_I() const { return x_I_; }
  const Vec3& y_I() const { return y_I_; }
  const Vec3& z_I() const { return z_I_; }

 private:
  double hub_height_m_;
  Vec3 x_I_, y_I_, z_I_;
};

/// A field turned as a whole about the rotor centre (0, 0, hub height). Positions are taken into W,
/// the velocity found there is taken back; so the pattern travels along the inclined mean wind, and
/// a beam straight ahead looks past the air that will meet the rotor.
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
  double mean_speed_mps() const override { return field_->mean_speed_mps() * axes_.x_I().x; }
  WindExtent extent() const override { return extent_; }
  double period_s() const override { return field_->period_s(); }
  bool holds(const Vec3& position_I_m) const override {
    return field_->holds(axes_.place_in_field(position_I_m));
  }
  /// The field's own points; the raster where it has but one, since the rotor cuts through planes.
  std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const override;

 private:
  void set_extent(double reach_m);

  std::unique_ptr<const WindField> field_;
  WindAxes axes_;
  double delay_s_ = 0.0;  // what is passed over
  WindExtent extent_;
};

}  // namespace lac::sim
