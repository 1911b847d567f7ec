// SPDX-License-Identifier: Apache-2.0
#include "feedback/pitch_actuator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lac {
namespace {

constexpr double kTimeStep_s = 0.0125;
constexpr PitchActuator::Params kParams{6.28, 0.7, 0.0, 1.5, 10.0};

// Without limits in the way a step gives the closed form of the second-order response.
TEST(PitchActuator, MatchesTheStepResponse) {
  const PitchActuator actuator(kParams, kTimeStep_s);
  PitchActuator::State state{0.2, 0.0};
  const double w = 6.28;
  const double z = 0.7;
  const double damped = w * std::sqrt(1.0 - z * z);
  for (int i = 1; i <= 200; ++i) {
    const double t = i * kTimeStep_s;
    const double expected =
        0.3 -
        0.1 * std::exp(-z * w * t) * (std::cos(damped * t) + z * w / damped * std::sin(damped * t));
    ASSERT_NEAR(actuator.step(0.3, state), expected, 1e-12) << t;
  }
}

// A ramp is followed with the delay 2 z/w.
TEST(PitchActuator, FollowsARampWithItsDelay) {
  const PitchActuator actuator(kParams, kTimeStep_s);
  PitchActuator::State state{0.0, 0.0};
  double pitch = 0.0;
  double demand = 0.0;
  for (int i = 0; i < 800; ++i) {
    demand = 0.1 * i * kTimeStep_s;
    pitch = actuator.step(demand, state);
  }
  // The demand holds over the step, the pitch is that at its end: half a step of delay in all.
  EXPECT_NEAR(demand - pitch, 0.1 * (2.0 * 0.7 / 6.28 - 0.5 * kTimeStep_s), 1e-8);
}

// Rate and angle stay within the limits, and it leaves a stop at once.
TEST(PitchActuator, RespectsLimits) {
  PitchActuator::Params p = kParams;
  p.max_rate_radps = 0.14;
  const PitchActuator actuator(p, kTimeStep_s);
  PitchActuator::State state{0.1, 0.0};
  double last = 0.1;
  double fastest = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double pitch = actuator.step(-0.2, state);
    fastest = std::max(fastest, std::abs(pitch - last) / kTimeStep_s);
    last = pitch;
    ASSERT_GE(pitch, 0.0);
  }
  EXPECT_NEAR(fastest, 0.14, 1e-9);
  EXPECT_EQ(last, 0.0);
  EXPECT_EQ(state.rate_radps, 0.0);
  EXPECT_GT(actuator.step(0.2, state), 0.0);
}

}  // namespace
}  // namespace lac
