// SPDX-License-Identifier: Apache-2.0
#include "bridge/increment.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac {
namespace {

constexpr double kStep_s = 0.0125;

double after(const Increment& increment, double rate_radps, double time_s, Increment::State& s) {
  for (int i = 0; i < static_cast<int>(std::lround(time_s / kStep_s)); ++i) {
    increment.step(true, rate_radps, s);
  }
  return s.pitch_rad;
}

// A constant rate r: x(t) = r T (1 - exp(-t/T)), at any time.
TEST(Increment, ConstantRateGivesTheExponential) {
  const Increment increment({30.0, 1.0, 10.0}, kStep_s);
  Increment::State s;
  for (const double t_s : {1.0, 10.0, 60.0, 300.0}) {
    s = {};
    EXPECT_NEAR(after(increment, 0.005, t_s, s), 0.005 * 30.0 * -std::expm1(-t_s / 30.0), 1e-13);
  }
}

// The step response falls with the leak: x(t) = x_0 exp(-t/T) without a rate.
TEST(Increment, LeaksWithItsTimeConstant) {
  const Increment increment({30.0, 1.0, 10.0}, kStep_s);
  Increment::State s{0.08, 0.0, true};
  EXPECT_NEAR(after(increment, 0.0, 45.0, s), 0.08 * std::exp(-1.5), 1e-13);
}

// T = 0: a plain integral.
TEST(Increment, WithoutLeakItIsTheIntegral) {
  const Increment increment({0.0, 1.0, 10.0}, kStep_s);
  Increment::State s;
  EXPECT_NEAR(after(increment, 0.002, 100.0, s), 0.2, 1e-12);
  EXPECT_NEAR(after(increment, -0.002, 100.0, s), 0.0, 1e-12);
}

// Authority holds both ways, says so, and leaves nothing to unwind.
TEST(Increment, Authority) {
  const Increment increment({0.0, 0.05, 10.0}, kStep_s);
  Increment::State s;
  EXPECT_EQ(after(increment, 0.01, 60.0, s), 0.05);
  EXPECT_TRUE(increment.step(true, 0.01, s));
  EXPECT_FALSE(increment.step(true, -0.01, s));
  EXPECT_DOUBLE_EQ(s.pitch_rad, 0.05 - 0.01 * kStep_s);
  EXPECT_EQ(after(increment, -0.01, 60.0, s), -0.05);
}

// Off: a straight line to exactly zero within the fade time, from wherever it was.
TEST(Increment, FadesToZeroInTime) {
  const Increment increment({30.0, 0.1, 10.0}, kStep_s);
  for (const double from_rad : {0.08, -0.03}) {
    Increment::State s{from_rad, 0.0, true};
    double before = from_rad;
    for (int i = 1; i <= 800; ++i) {
      increment.step(false, 0.0, s);
      EXPECT_NEAR(s.pitch_rad, from_rad * (1.0 - i / 800.0), 1e-12);
      EXPECT_NEAR(s.pitch_rad - before, -from_rad / 800.0, 1e-14);
      before = s.pitch_rad;
    }
    increment.step(false, 0.0, s);
    EXPECT_EQ(s.pitch_rad, 0.0);
  }
}

// On again in the middle of the fade: it goes on from where it is.
TEST(Increment, ResumesWhereItIs) {
  const Increment increment({0.0, 0.1, 10.0}, kStep_s);
  Increment::State s{0.08, 0.0, true};
  for (int i = 0; i < 400; ++i) increment.step(false, 0.0, s);
  increment.step(true, 0.004, s);
  EXPECT_NEAR(s.pitch_rad, 0.04 + 0.004 * kStep_s, 1e-12);
}

// A rate that is not a number is not looked at while off.
TEST(Increment, OffIgnoresTheRate) {
  const Increment increment({30.0, 0.1, 10.0}, kStep_s);
  Increment::State s{0.08, 0.0, true};
  increment.step(false, std::nan(""), s);
  EXPECT_NEAR(s.pitch_rad, 0.08 * 799.0 / 800.0, 1e-15);
}

}  // namespace
}  // namespace lac
