// SPDX-License-Identifier: Apache-2.0
#include "feedback/limited_pi.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac {
namespace {

constexpr double kTimeStep_s = 0.0125;
constexpr LimitedPi::Gains kGains{0.02, 3.0};
constexpr LimitedPi::Limits kLimits{0.0, 1.5, 0.14};

LimitedPi started(double error, double output) {
  LimitedPi pi;
  pi.start(error, output, kGains, kLimits);
  return pi;
}

// Free of limits it is k_p e + k_p/T_I int e dt.
TEST(LimitedPi, FollowsTheLaw) {
  LimitedPi pi = started(0.0, 0.5);
  double integral = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double error = std::sin(0.01 * i);
    integral += kTimeStep_s * error;
    const double expected = 0.5 + 0.02 * error + 0.02 / 3.0 * integral;
    ASSERT_NEAR(pi.step(error, 0.0, kGains, kLimits, kTimeStep_s), expected, 1e-12);
  }
}

// Whatever the error, it starts at the given output and goes on from there.
TEST(LimitedPi, StartsWithoutBump) {
  LimitedPi pi = started(2.0, 0.3);
  EXPECT_EQ(pi.output(), 0.3);
  EXPECT_NEAR(pi.step(2.0, 0.0, kGains, kLimits, kTimeStep_s), 0.3 + 0.04 / 3.0 * kTimeStep_s,
              1e-12);
}

// The feed rate integrates to its angle when the error is zero.
TEST(LimitedPi, IntegratesTheFeedRate) {
  LimitedPi pi = started(0.0, 0.2);
  double angle = 0.0;
  for (int i = 0; i < 800; ++i) {
    const double rate = 0.05 * std::cos(0.005 * i);
    angle += kTimeStep_s * rate;
    ASSERT_NEAR(pi.step(0.0, rate, kGains, kLimits, kTimeStep_s), 0.2 + angle, 1e-12);
  }
}

// However long at a limit, it leaves it in the step in which the error changes sign.
TEST(LimitedPi, LeavesBothLimitsAtOnce) {
  for (const double side : {-1.0, 1.0}) {
    const double limit = side < 0.0 ? kLimits.min : kLimits.max;
    LimitedPi pi = started(0.0, 0.7);
    for (int i = 0; i < 80 * 600; ++i) {
      pi.step(side * 30.0 * (1.0 + 0.3 * std::sin(0.02 * i)), 0.0, kGains, kLimits, kTimeStep_s);
    }
    ASSERT_EQ(pi.output(), limit);
    const double left = pi.step(-side * 0.05, 0.0, kGains, kLimits, kTimeStep_s);
    EXPECT_NEAR(left, limit - side * 0.05 * 0.02, 1e-5);
  }
}

// A feed rate against a limit winds nothing up either.
TEST(LimitedPi, FeedRateAgainstALimitDoesNotWindUp) {
  LimitedPi pi = started(0.0, 0.1);
  for (int i = 0; i < 80 * 60; ++i) pi.step(0.0, -0.05, kGains, kLimits, kTimeStep_s);
  ASSERT_EQ(pi.output(), 0.0);
  EXPECT_NEAR(pi.step(0.0, 0.05, kGains, kLimits, kTimeStep_s), 0.05 * kTimeStep_s, 1e-12);
}

// No step is larger than the rate allows, and a feed rate above it leaves the integral no more
// than T_I times the excess ahead of the output.
TEST(LimitedPi, RespectsTheRate) {
  LimitedPi pi = started(0.0, 0.1);
  double last = pi.output();
  for (int i = 0; i < 80 * 5; ++i) {
    const double output = pi.step(0.0, 0.2, kGains, kLimits, kTimeStep_s);
    ASSERT_LE(std::abs(output - last), kLimits.rate_per_s * kTimeStep_s * (1.0 + 1e-9));
    last = output;
  }
  EXPECT_NEAR(last, 0.1 + 5.0 * kLimits.rate_per_s, 1e-9);
  EXPECT_LE(pi.integral() - last, kGains.integral_time_s * (0.2 - kLimits.rate_per_s));
  EXPECT_GT(pi.integral(), last);
}

// Started outside the limits it comes back at the rate, without a jump.
TEST(LimitedPi, ComesBackFromOutside) {
  LimitedPi pi = started(0.0, -0.1);
  EXPECT_EQ(pi.output(), -0.1);
  EXPECT_NEAR(pi.step(0.0, 0.0, kGains, kLimits, kTimeStep_s), -0.1 + 0.14 * kTimeStep_s, 1e-12);
}

}  // namespace
}  // namespace lac
