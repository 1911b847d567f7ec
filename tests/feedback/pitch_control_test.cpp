// SPDX-License-Identifier: Apache-2.0
#include "feedback/pitch_control.hpp"

#include <gtest/gtest.h>

#include "feedback/nrel5mw.hpp"

namespace lac {
namespace {

constexpr double kTimeStep_s = 0.0125;

PitchControl::Params params() {
  return test::shipped_params().pitch;
}

// Too fast pitches to feather, too slow to fine; the gains are those of the measured pitch.
TEST(PitchControl, ActsInTheRightSenseWithScheduledGains) {
  const PitchControl::Params p = params();
  const PitchControl control(p, kTimeStep_s);
  for (const double pitch : {0.1, 0.25, 0.35}) {
    const LimitedPi::Gains gains = p.gains.at(pitch);
    for (const double error : {0.05, -0.05}) {
      PitchControl::State state;
      control.start(p.rated_speed_radps, pitch, state);
      const double demand = control.step(p.rated_speed_radps + error, 0.0, pitch, 0.0, state);
      EXPECT_NEAR(demand - pitch,
                  gains.proportional * error * (1.0 + kTimeStep_s / gains.integral_time_s), 1e-12);
    }
  }
}

// The gains lie on straight lines between the design points and are constant outside.
TEST(PitchControl, InterpolatesTheGains) {
  const PitchGainSchedule gains = params().gains;
  const auto& x = gains.proportional_s.x();
  const auto& k_p = gains.proportional_s.y();
  EXPECT_EQ(gains.at(0.0).proportional, k_p.front());
  EXPECT_NEAR(gains.at(0.5 * (x[1] + x[2])).proportional, 0.5 * (k_p[1] + k_p[2]), 1e-12);
  EXPECT_EQ(gains.at(1.0).integral_time_s, gains.integral_time_s.y().back());
}

// A negative shift (power is short) raises the reference, a positive one leaves it.
TEST(PitchControl, ShiftRaisesTheReference) {
  const PitchControl::Params p = params();
  const PitchControl control(p, kTimeStep_s);
  const auto move = [&](double speed, double shift) {
    PitchControl::State state;
    control.start(p.rated_speed_radps, 0.2, state);
    return control.step(speed, shift, 0.2, 0.0, state) - 0.2;
  };
  EXPECT_NEAR(move(p.rated_speed_radps + 3.0, -3.0), 0.0, 1e-12);
  EXPECT_NEAR(move(p.rated_speed_radps, 5.0), 0.0, 1e-12);
  EXPECT_LT(move(p.rated_speed_radps, -5.0), 0.0);
}

// After ten minutes below rated it leaves the fine pitch in the step in which the speed exceeds
// the reference.
TEST(PitchControl, LeavesTheFinePitchAtOnce) {
  const PitchControl::Params p = params();
  const PitchControl control(p, kTimeStep_s);
  PitchControl::State state;
  control.start(90.0, 0.0, state);
  for (int i = 0; i < 80 * 600; ++i) ASSERT_EQ(control.step(90.0, -8.0, 0.0, 0.0, state), 0.0);
  EXPECT_GT(control.step(p.rated_speed_radps + 0.01, 0.0, 0.0, 0.0, state), 0.0);
}

// Started at fine pitch and low speed there is no angle in store that a gust would release.
TEST(PitchControl, StartsIdleBelowRated) {
  const PitchControl control(params(), kTimeStep_s);
  PitchControl::State state;
  control.start(90.0, 0.0, state);
  EXPECT_EQ(state.integral(), 0.0);
  EXPECT_EQ(state.output(), 0.0);
}

}  // namespace
}  // namespace lac
