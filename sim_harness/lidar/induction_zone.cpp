// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/induction_zone.hpp"

#include <cmath>

namespace lac::sim {
namespace {

constexpr double kInflowTimeFactor = 1.1;  // Oye's slow time constant is 1.1 R/U at light loading
constexpr double kLargestThrust = 16.0 / 9.0;  // a = 1

}  // namespace

InductionParams read_induction(YamlReader& in) {
  InductionParams p;
  p.model = static_cast<InductionModel>(
      in.choice("model", {"none", "one_dimensional", "vortex_cylinder"}));
  const bool is_off = p.model == InductionModel::kNone;
  if (!is_off || in.has("thrust_coefficient")) {
    p.follows_thrust = in.text("thrust_coefficient") == "turbine";
    if (!p.follows_thrust) {
      p.thrust_coefficient = in.number("thrust_coefficient", Range::between(0.0, kLargestThrust));
    }
  }
  if (in.has("time_constant_s")) {
    p.time_constant_s = in.number("time_constant_s", Range::positive());
    if (!is_off && !p.follows_thrust) {
      in.fail("time_constant_s", "expected thrust_coefficient: turbine, a number does not change");
    }
  }
  return is_off ? InductionParams{} : p;
}

InductionZone::InductionZone(const InductionParams& params, double rotor_radius_m,
                             double mean_speed_mps)
    : params_(params),
      radius_m_(rotor_radius_m),
      time_constant_s_(params.time_constant_s > 0.0
                           ? params.time_constant_s
                           : kInflowTimeFactor * rotor_radius_m / mean_speed_mps),
      thrust_coefficient_(params.thrust_coefficient),
      factor_(lac::induction_factor(params.thrust_coefficient)) {}

void InductionZone::advance(double thrust_coefficient, double step_s) noexcept {
  if (!active() || !params_.follows_thrust) return;
  const double share = started_ ? -std::expm1(-step_s / time_constant_s_) : 1.0;
  started_ = true;
  thrust_coefficient_ += share * (thrust_coefficient - thrust_coefficient_);
  factor_ = lac::induction_factor(thrust_coefficient_);
}

Vec3 InductionZone::disturbed(const Vec3& free_mps,
                              const Vec3& from_rotor_centre_I_m) const noexcept {
  if (!active()) return free_mps;
  const Vec3& p = from_rotor_centre_I_m;
  const double r_m = std::sqrt(p.y * p.y + p.z * p.z);
  const UnitInduction unit = params_.model == InductionModel::kOneDimensional
                                 ? one_dimensional_induction(p.x, radius_m_)
                                 : vortex_cylinder_induction(p.x, r_m, radius_m_);
  const double scale_mps = factor_ * free_mps.x;
  const double outwards = r_m > 0.0 ? scale_mps * unit.radial / r_m : 0.0;
  return free_mps + Vec3{-scale_mps * unit.axial, outwards * p.y, outwards * p.z};
}

}  // namespace lac::sim
