// SPDX-License-Identifier: Apache-2.0
#include "feedback/set_point_fading.hpp"

#include <gtest/gtest.h>

namespace lac {
namespace {

constexpr double kTimeStep_s = 0.0125;
constexpr SetPointFading::Params kParams{12.3, rad_from_deg(25.0), 5.0e6, 0.1};

double settled(double pitch_rad, double short_W) {
  const SetPointFading fading(kParams, kTimeStep_s);
  SetPointFading::State state;
  return fading.step(pitch_rad, short_W, state);
}

// The formula: pitch raises the shift, missing power lowers it, both meet at zero.
TEST(SetPointFading, FollowsTheFormula) {
  EXPECT_DOUBLE_EQ(settled(0.0, 0.0), 0.0);
  EXPECT_NEAR(settled(rad_from_deg(10.0), 0.0), 12.3 * 0.4, 1e-12);
  EXPECT_NEAR(settled(0.0, 1.0e6), -12.3 * 0.2, 1e-12);
  EXPECT_NEAR(settled(rad_from_deg(5.0), 1.0e6), 0.0, 1e-12);
}

// Never more than DeltaOmega to either side.
TEST(SetPointFading, IsLimited) {
  EXPECT_DOUBLE_EQ(settled(rad_from_deg(80.0), 0.0), 12.3);
  EXPECT_DOUBLE_EQ(settled(0.0, 9.0e6), -12.3);
}

// A step passes the low-pass: 63 % after one time constant 1/(2 pi f).
TEST(SetPointFading, IsLowPassed) {
  const SetPointFading fading(kParams, kTimeStep_s);
  SetPointFading::State state;
  fading.step(0.0, 0.0, state);
  double d = 0.0;
  for (int i = 0; i < 127; ++i) d = fading.step(rad_from_deg(25.0), 0.0, state);
  const double time_s = 126.5 * kTimeStep_s;  // the trapezoidal rule sees half of the first step
  EXPECT_NEAR(d, 12.3 * (1.0 - std::exp(-radps_from_hz(0.1) * time_s)), 1e-3);
}

}  // namespace
}  // namespace lac
