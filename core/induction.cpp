// SPDX-License-Identifier: Apache-2.0
#include "core/induction.hpp"

#include <algorithm>
#include <cmath>

#include "core/elliptic_integral.hpp"
#include "core/units.hpp"

namespace lac {
namespace {

constexpr double kRimDistance = 1e-9;  // of r from R, and of kc from 0: nearer counts as this near
constexpr double kHeavyFactor = 1.0 / 3.0;
constexpr double kHeavyThrust = 8.0 / 9.0;
constexpr double kHeavySlope = 3.0 / 4.0;

/// Without the care for overflow that makes std::hypot slow.
double length(double a, double b) noexcept {
  return std::sqrt(a * a + b * b);
}

}  // namespace

double induction_factor(double thrust_coefficient) noexcept {
  if (thrust_coefficient > kHeavyThrust) {
    return kHeavyFactor + kHeavySlope * (thrust_coefficient - kHeavyThrust);
  }
  return 0.5 * (1.0 - std::sqrt(1.0 - thrust_coefficient));
}

UnitInduction one_dimensional_induction(double x_m, double rotor_radius_m) noexcept {
  return {1.0 + x_m / length(x_m, rotor_radius_m), 0.0};
}

UnitInduction vortex_cylinder_induction(double x_m, double r_m, double rotor_radius_m) noexcept {
  const double sum_m = rotor_radius_m + r_m;
  const double far_m = length(x_m, sum_m);
  const double kc = std::max(length(x_m, rotor_radius_m - r_m) / far_m, kRimDistance);
  const double inside = r_m <= rotor_radius_m ? 1.0 : 0.0;
  const double gamma =
      (2.0 * inside - 1.0) * std::max(std::abs(rotor_radius_m - r_m) / sum_m, kRimDistance);
  const double scale = 2.0 / kPi * rotor_radius_m;
  const double axial =
      scale / sum_m * x_m / far_m * complete_elliptic_integral(kc, gamma * gamma, 1.0, gamma);
  const double radial = -scale / far_m * complete_elliptic_integral(kc, 1.0, 1.0, -1.0);
  return {inside + axial, radial};
}

}  // namespace lac
