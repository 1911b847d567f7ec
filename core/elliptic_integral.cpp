// SPDX-License-Identifier: Apache-2.0
#include "core/elliptic_integral.hpp"

#include <cmath>

#include "core/units.hpp"

namespace lac {
namespace {

constexpr int kMostSteps = 40;  // convergence is quadratic: ten are enough for any kc above 1e-300
constexpr double kTolerance = 1e-8;  // of the means; the error of the result is its square

}  // namespace

double complete_elliptic_integral(double kc, double p, double a, double b) noexcept {
  double root_p = std::sqrt(p);
  double numerator = b / root_p;
  double arithmetic = 1.0;
  double geometric = kc;
  double product = kc;
  for (int step = 0; step < kMostSteps; ++step) {
    const double a_before = a;
    a += numerator / root_p;
    const double ratio = product / root_p;
    numerator = 2.0 * (numerator + a_before * ratio);
    root_p += ratio;
    const double mean = arithmetic;
    arithmetic += geometric;
    if (std::abs(mean - geometric) <= mean * kTolerance) break;
    geometric = 2.0 * std::sqrt(product);
    product = geometric * arithmetic;
  }
  return 0.5 * kPi * (numerator + a * arithmetic) / (arithmetic * (arithmetic + root_p));
}

}  // namespace lac
