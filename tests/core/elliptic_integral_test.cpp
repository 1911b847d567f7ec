// SPDX-License-Identifier: Apache-2.0
#include "core/elliptic_integral.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"

namespace lac {
namespace {

constexpr double kRounding = 1e-14;

// Complete integrals of the first, second and third kind, 16 digits, by tanh-sinh quadrature of
// another program; the values at m = 1/2 are also those of Abramowitz and Stegun, table 17.1.
TEST(EllipticIntegral, TheThreeKinds) {
  const struct {
    double m, first, second, third;  // Pi(0.4 | m)
  } table[] = {{0.25, 1.6857503548125960, 1.4674622093394272, 2.1962905366178066},
               {0.50, 1.8540746773013719, 1.3506438810476755, 2.4468304338684888},
               {0.90, 2.5780921133481732, 1.1047747327040733, 3.5686606928995649}};
  for (const auto& row : table) {
    const double kc = std::sqrt(1.0 - row.m);
    EXPECT_NEAR(complete_elliptic_integral(kc, 1.0, 1.0, 1.0), row.first, kRounding * row.first);
    EXPECT_NEAR(complete_elliptic_integral(kc, 1.0, 1.0, kc * kc), row.second, kRounding);
    EXPECT_NEAR(complete_elliptic_integral(kc, 0.6, 1.0, 1.0), row.third, kRounding * row.third);
  }
}

// General coefficients, small kc: quadrature as above; and kc = 1, where the integral is closed.
TEST(EllipticIntegral, GeneralCoefficients) {
  EXPECT_NEAR(complete_elliptic_integral(0.3, 0.2, 1.0, -0.4), -0.93255236851811697889, 1e-14);
  EXPECT_NEAR(complete_elliptic_integral(0.01, 0.5, 0.7, 2.0), 19.854471898533664868, 2e-13);
  const double g = 0.3;
  EXPECT_NEAR(complete_elliptic_integral(1.0, g * g, 1.0, g), kPi / (1.0 + g), kRounding);
}

}  // namespace
}  // namespace lac
