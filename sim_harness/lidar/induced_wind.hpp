// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_harness/lidar/induction_zone.hpp"
#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

/// The wind of a field as it is up-wind of a turning rotor. One turbine's: it follows its rotor.
class InducedWind final : public WindField {
 public:
  /// The field must outlive this object.
  InducedWind(const WindField& field, const InductionParams& params, double rotor_radius_m)
      : field_(field), zone_(params, rotor_radius_m, field.mean_speed_mps()) {}

  /// To be called in every controller step, before the wind is asked for.
  void follow(double thrust_coefficient, const Vec3& rotor_centre_I_m, double step_s) {
    zone_.advance(thrust_coefficient, step_s);
    rotor_centre_I_m_ = rotor_centre_I_m;
  }

  Vec3 velocity(const Vec3& position_I_m, double time_s) const override {
    return zone_.disturbed(field_.velocity(position_I_m, time_s), position_I_m - rotor_centre_I_m_);
  }
  double mean_speed_mps() const override { return field_.mean_speed_mps(); }
  WindExtent extent() const override { return field_.extent(); }
  double period_s() const override { return field_.period_s(); }
  bool holds(const Vec3& position_I_m) const override { return field_.holds(position_I_m); }
  std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const override {
    return field_.disk_points(hub_height_m, radius_m);
  }

 private:
  const WindField& field_;
  InductionZone zone_;
  Vec3 rotor_centre_I_m_;
};

}  // namespace lac::sim
