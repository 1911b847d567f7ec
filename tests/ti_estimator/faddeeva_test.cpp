// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/faddeeva.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac {
namespace {

// On the real axis: exp(-x^2).
TEST(Faddeeva, RealAxis) {
  const Faddeeva w;
  for (double x = 0.0; x < 12.0; x += 0.137) {
    EXPECT_NEAR(w.real_part(x, 0.0), std::exp(-x * x), 1e-11) << x;
  }
}

// On the imaginary axis: exp(y^2) erfc(y).
TEST(Faddeeva, ImaginaryAxis) {
  const Faddeeva w;
  for (double y = 0.0; y < 5.0; y += 0.083) {
    EXPECT_NEAR(w.real_part(0.0, y), std::exp(y * y) * std::erfc(y), 1e-11) << y;
  }
}

// Between the axes: scipy.special.wofz (python/check_c_ti.py).
TEST(Faddeeva, BetweenTheAxes) {
  const Faddeeva w;
  EXPECT_NEAR(w.real_part(1.0, 1.0), 0.30474420525691, 1e-11);
  EXPECT_NEAR(w.real_part(3.0, 0.1), 0.00794268099877, 1e-11);
  EXPECT_NEAR(w.real_part(0.02, 7.0), 0.07979943385024, 1e-11);
}

}  // namespace
}  // namespace lac
