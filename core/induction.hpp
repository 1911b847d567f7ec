// SPDX-License-Identifier: Apache-2.0
// How a rotor slows the wind that comes to it. Shared by the simulated lidar and by what corrects a
// measured one.
#pragma once

namespace lac {

/// Axial induction factor of a thrust coefficient: C_T = 4 a (1 - a) up to a = 1/3 (C_T = 8/9),
/// its tangent there beyond, a = 1/3 + 3/4 (C_T - 8/9). A negative C_T speeds the wind up.
double induction_factor(double thrust_coefficient) noexcept;

enum class InductionModel { kNone, kOneDimensional, kVortexCylinder };

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

}  // namespace lac
