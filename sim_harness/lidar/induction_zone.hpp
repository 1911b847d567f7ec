// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/induction.hpp"
#include "core/vec3.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

struct InductionParams {
  InductionModel model = InductionModel::kNone;
  bool follows_thrust = false;  // else thrust_coefficient holds
  double thrust_coefficient = 0.0;
  double time_constant_s = 0.0;  // of the low-pass of C_T; 0: that of dynamic inflow, 1.1 R/U
};

/// Map `induction`: model (none, one_dimensional, vortex_cylinder), thrust_coefficient (a number,
/// or `turbine`), time_constant_s. With `none` the others may be there and are checked. Throws
/// lac::Error.
InductionParams read_induction(YamlReader& in);

/// The wind up-wind of a rotor whose axis is x of frame I:
///
///   U + a u_free (-axial e_x + radial e_r)
///
/// u_free is the undisturbed u at the same point and time: gusts are slowed like the mean, which
/// holds for those that are long against R/U. Lateral turbulence passes as it is.
class InductionZone {
 public:
  InductionZone(const InductionParams& params, double rotor_radius_m, double mean_speed_mps);

  bool active() const noexcept { return params_.model != InductionModel::kNone; }
  /// One controller step with the turbine's present thrust coefficient, first-order low-pass; the
  /// first call sets it.
  void advance(double thrust_coefficient, double step_s) noexcept;
  double induction_factor() const noexcept { return factor_; }

  Vec3 disturbed(const Vec3& free_mps, const Vec3& from_rotor_centre_I_m) const noexcept;

 private:
  InductionParams params_;
  double radius_m_;
  double time_constant_s_;
  double thrust_coefficient_;
  double factor_;
  bool started_ = false;
};

}  // namespace lac::sim
