// SPDX-License-Identifier: Apache-2.0
#include "feedback/feedback.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "feedback/nrel5mw.hpp"
#include "support/no_alloc_guard.hpp"

namespace lac {
namespace {

constexpr double kTimeStep_s = 0.0125;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A controller with its state, at rest at rated speed above rated wind.
struct Controller {
  explicit Controller(const FeedbackParams& p = test::shipped_params(), double pitch_rad = 0.26)
      : params(p), feedback(p, kTimeStep_s) {
    in.generator_speed_radps = p.torque.rated_speed_radps;
    in.pitch_rad = pitch_rad;
    out = feedback.step(in, state, events);
  }
  const Feedback::Outputs& step() {
    events = {};
    out = feedback.step(in, state, events);
    return out;
  }
  FeedbackParams params;
  Feedback feedback;
  Feedback::State state;
  Feedback::Inputs in;
  Feedback::Events events;
  Feedback::Outputs out;
};

// Above rated, with no torque measured yet: the first demands are the measured pitch and rated
// power, and they stay there.
TEST(Feedback, StartsWithoutBumpAboveRated) {
  Controller c;
  EXPECT_EQ(c.out.pitch_rad, 0.26);
  EXPECT_NEAR(c.out.torque_Nm, 43093.55, 1e-6);
  EXPECT_EQ(c.out.region, TorqueRegion::Rated);
  for (int i = 0; i < 800; ++i) c.step();
  EXPECT_NEAR(c.out.pitch_rad, 0.26, 1e-12);
  EXPECT_NEAR(c.out.torque_Nm, 43093.55, 1e-6);
}

// Started off its set point the pitch still begins where the blades are, and moves by the
// integral alone.
TEST(Feedback, StartsWithoutBumpOffTheSetPoint) {
  const FeedbackParams p = test::shipped_params();
  const Feedback feedback(p, kTimeStep_s);
  Feedback::State state;
  Feedback::Events events;
  const Feedback::Inputs in{p.torque.rated_speed_radps + 2.0, 0.26};
  EXPECT_EQ(feedback.step(in, state, events).pitch_rad, 0.26);
  const LimitedPi::Gains gains = p.pitch.gains.at(0.26);
  EXPECT_NEAR(feedback.step(in, state, events).pitch_rad - 0.26,
              gains.proportional / gains.integral_time_s * 2.0 * kTimeStep_s, 1e-9);
}

// Below rated: fine pitch and k Omega^2; a measured torque is taken over if there is one.
TEST(Feedback, StartsAtTheOperatingPointBelowRated) {
  const Feedback feedback(test::shipped_params(), kTimeStep_s);
  Feedback::Events events;
  Feedback::State state;
  const Feedback::Outputs out = feedback.step({93.0, 0.0}, state, events);
  EXPECT_EQ(out.pitch_rad, 0.0);
  EXPECT_NEAR(out.torque_Nm, 2.3323 * 93.0 * 93.0, 1e-9);
  EXPECT_EQ(out.region, TorqueRegion::Optimal);
  Feedback::State warm;
  EXPECT_EQ(feedback.step({122.0, 0.0, 40000.0}, warm, events).torque_Nm, 40000.0);
}

// Ten seconds without numbers: nothing moves and nothing is counted in the state but the steps;
// one event at each end; then the run goes on as if the gap had not been.
TEST(Feedback, HoldsWhileInputsAreNoNumbers) {
  const auto bad_inputs = [](int kind, Feedback::Inputs in) {
    if (kind == 0) in.generator_speed_radps = kNan;
    if (kind == 1) in.pitch_rad = std::numeric_limits<double>::infinity();
    if (kind == 2) in.good = false;
    return in;
  };
  for (int kind = 0; kind < 3; ++kind) {
    Controller held;
    Controller plain;
    for (int i = 0; i < 100; ++i) {
      held.in.generator_speed_radps = plain.in.generator_speed_radps = 122.9 + 0.01 * i;
      held.step();
      plain.step();
    }
    const Feedback::Inputs good = held.in;
    const Feedback::Outputs before = held.out;
    for (int i = 0; i < 800; ++i) {
      held.in = bad_inputs(kind, good);
      held.step();
      ASSERT_EQ(held.events.hold_began, i == 0);
      ASSERT_EQ(held.out.pitch_rad, before.pitch_rad);
      ASSERT_EQ(held.out.torque_Nm, before.torque_Nm);
    }
    held.in = good;
    held.step();
    EXPECT_EQ(held.events.recovered_after_steps, 800);
    EXPECT_EQ(held.out.pitch_rad, plain.step().pitch_rad);
    held.step();
    EXPECT_EQ(held.events.recovered_after_steps, 0);
  }
}

// Whatever the speed is after a gap, the demands go on from the held ones within their rates.
TEST(Feedback, RecoversWithinTheRates) {
  Controller c;
  const Feedback::Outputs before = c.out;
  c.in.generator_speed_radps = kNan;
  for (int i = 0; i < 80; ++i) c.step();
  c.in.generator_speed_radps = 160.0;
  c.step();
  EXPECT_LE(std::abs(c.out.pitch_rad - before.pitch_rad),
            c.params.pitch.max_rate_radps * kTimeStep_s * (1.0 + 1e-9));
  EXPECT_LE(std::abs(c.out.torque_Nm - before.torque_Nm), 15000.0 * kTimeStep_s * (1.0 + 1e-9));
}

// Nothing good at the first call: the blades stay, no torque; the start follows.
TEST(Feedback, WaitsForItsStart) {
  const FeedbackParams p = test::shipped_params();
  const Feedback feedback(p, kTimeStep_s);
  Feedback::State state;
  Feedback::Events events;
  const Feedback::Outputs out = feedback.step({kNan, 0.3}, state, events);
  EXPECT_TRUE(events.hold_began);
  EXPECT_EQ(out.pitch_rad, 0.3);
  EXPECT_EQ(out.torque_Nm, 0.0);
  EXPECT_EQ(feedback.step({kNan, kNan}, state, events).pitch_rad, 0.0);
  const Feedback::Outputs first = feedback.step({p.torque.rated_speed_radps, 0.25}, state, events);
  EXPECT_EQ(events.recovered_after_steps, 2);
  EXPECT_EQ(first.pitch_rad, 0.25);
  EXPECT_NEAR(first.torque_Nm, 43093.55, 1e-6);
}

// With the speed on its set point the demand is the integral of the feedforward rate.
TEST(Feedback, IntegratesTheFeedforwardRate) {
  Controller c;
  double angle = 0.0;
  for (int i = 0; i < 1600; ++i) {
    c.in.feedforward_rate_radps = 0.02 * std::sin(0.01 * i);
    angle += kTimeStep_s * c.in.feedforward_rate_radps;
    ASSERT_NEAR(c.step().pitch_rad, 0.26 + angle, 1e-12);
  }
}

// A rate that is no number counts as zero and is told once per loss.
TEST(Feedback, FeedforwardThatIsNoNumberIsZero) {
  Controller c;
  int told = 0;
  for (int i = 0; i < 300; ++i) {
    c.in.feedforward_rate_radps = i < 100 || i >= 200 ? 0.0 : kNan;
    ASSERT_NEAR(c.step().pitch_rad, 0.26, 1e-12);
    told += c.events.feedforward_lost ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
}

// The power level moves at its rate to what is asked, scales the torque, and returns to 1 when
// nothing is asked or what is asked makes no sense, which is told once.
TEST(Feedback, FollowsThePowerLevel) {
  Controller c;
  c.in.power_level = 0.8;
  for (int i = 0; i < 80 * 10; ++i) c.step();
  EXPECT_NEAR(c.state.power_level, 0.9, 1e-9);
  EXPECT_NEAR(c.out.torque_Nm, 0.9 * 43093.55, 1.0);
  for (int i = 0; i < 80 * 15; ++i) c.step();
  EXPECT_NEAR(c.out.torque_Nm, 0.8 * 43093.55, 1e-6);
  int told = 0;
  c.in.power_level = kNan;
  for (int i = 0; i < 80 * 10; ++i) {
    c.step();
    told += c.events.power_level_lost ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
  EXPECT_NEAR(c.state.power_level, 0.9, 1e-9);
  c.in.power_level.reset();
  for (int i = 0; i < 80 * 15; ++i) c.step();
  EXPECT_NEAR(c.out.torque_Nm, 43093.55, 1e-6);
}

// The highest level, rounded to single precision by its record, is still in range.
TEST(Feedback, HighestPowerLevelSurvivesItsRecord) {
  Controller c;
  c.in.power_level = static_cast<double>(static_cast<float>(FeedbackParams{}.max_power_level));
  c.step();
  EXPECT_FALSE(c.events.power_level_lost);
  EXPECT_GT(c.state.power_level, 1.0);
}

// The actuator model delays the demand; without it the demand is the PI's own.
TEST(Feedback, ActuatorModelDelaysTheDemand) {
  FeedbackParams with = test::shipped_params();
  with.use_actuator = true;
  Controller delayed(with);
  Controller direct;
  for (int i = 0; i < 4; ++i) {
    delayed.in.generator_speed_radps = direct.in.generator_speed_radps = 125.0;
    delayed.step();
    direct.step();
  }
  EXPECT_GT(direct.out.pitch_rad, 0.26);
  EXPECT_GT(delayed.out.pitch_rad, 0.26);
  EXPECT_LT(delayed.out.pitch_rad - 0.26, 0.5 * (direct.out.pitch_rad - 0.26));
}

// Saved and loaded in mid-run the controller continues to the last bit.
TEST(Feedback, ContinuesFromACheckpoint) {
  FeedbackParams p = test::shipped_params();
  p.use_actuator = true;
  Controller c(p);
  const auto disturb = [](Controller& x, int i) {
    x.in.generator_speed_radps = 122.0 + 3.0 * std::sin(0.013 * i);
    x.in.pitch_rad = 0.2 + 0.05 * std::sin(0.01 * i);
    x.in.feedforward_rate_radps = 0.01 * std::cos(0.02 * i);
    x.in.power_level = 0.9;
    return x.step();
  };
  for (int i = 0; i < 3000; ++i) disturb(c, i);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  save(c.state);
  Controller loaded(p);
  StateArchive load{std::span<const std::byte>(bytes)};
  load(loaded.state);
  ASSERT_TRUE(load.complete());
  for (int i = 3000; i < 6000; ++i) {
    const Feedback::Outputs a = disturb(c, i);
    const Feedback::Outputs b = disturb(loaded, i);
    ASSERT_EQ(a.pitch_rad, b.pitch_rad) << i;
    ASSERT_EQ(a.torque_Nm, b.torque_Nm) << i;
    ASSERT_EQ(a.set_point_shift_radps, b.set_point_shift_radps) << i;
  }
}

// Steps do not allocate.
TEST(Feedback, DoesNotAllocate) {
  if (!test::kCountsAllocations) GTEST_SKIP() << "the sanitizer owns malloc";
  Controller c;
  const test::NoAllocGuard guard;
  for (int i = 0; i < 1000; ++i) {
    c.in.generator_speed_radps = i % 100 == 0 ? kNan : 100.0 + 0.03 * i;
    c.step();
  }
  EXPECT_EQ(guard.allocations(), 0U);
}

}  // namespace
}  // namespace lac
