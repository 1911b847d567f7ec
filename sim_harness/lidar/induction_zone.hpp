// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/vec3.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

/// Axial induction factor of a thrust coefficient: C_T = 4 a (1 - a) up to a = 1/3 (C_T = 8/9),
/// its tangent there beyond, a = 1/3 + 3/4 (C_T - 8/9). A negative C_T speeds the wind up.
double induction_factor(double thrust_coefficient) noexcept;

/// What a rotor with a = 1 in unit wind does to the wind at a point: slows it by `axial` along x,
/// pushes it outwards by `radial`. Both are linear in a and in the wind speed.
struct UnitInduction {
  double axial = 0.0;
  double radial = 0.0;
};

/// On the rotor axis, 1 + xi / sqrt(1 + xi^2) with xi = x / R (Medici et al. 2011), x < 0 up-wind.
/// Without a dependence on the distance from the axis and so without radial velocity: a beam that
/// looks past the rotor is slowed too much.
UnitInduction one_dimensional_induction(double x_m, double rotor_radius_m) noexcept;

/// A cylinder of tangential vorticity from the rotor plane to infinity down-wind (Branlard and
/// Gaunaa 2015, eqs. 7, 8), in the closed form of the half-infinite solenoid (Derby and Olbert
/// 2010, eqs. 3-5), which it is. On the axis it is the one-dimensional model. Precondition: r >= 0.
/// On the rim, where the radial velocity is infinite, it is that of 1e-9 R beside it.
UnitInduction vortex_cylinder_induction(double x_m, double r_m, double rotor_radius_m) noexcept;

enum class InductionModel { kNone, kOneDimensional, kVortexCylinder };

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
