// SPDX-License-Identifier: Apache-2.0
#include "bridge/bridge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "support/no_alloc_guard.hpp"

namespace lac {
namespace {

constexpr double kStep_s = 0.0125;
const double kNan = std::nan("");

BridgeParams params(FeedforwardRoute route, DeratingRoute derating = DeratingRoute::None) {
  BridgeParams p;
  p.feedforward = route;
  p.increment = {30.0, 0.1, 10.0};
  p.tower_damper_gain = 0.01;
  p.limits = {0.0, 1.5, 0.1};
  p.derating = derating;
  return p;
}

struct Controller {
  explicit Controller(const BridgeParams& p) : bridge(p, kStep_s) {
    in.active = 1.0;
    in.demands.fill(0.3F);
  }

  /// One step with the blades where the sum of the step before put them.
  const Bridge::Outputs& step() {
    in.pitch_rad = static_cast<double>(out.demands[0]);
    events = {};
    out = bridge.step(in, state, events);
    return out;
  }
  void steps(double time_s) {
    for (int i = 0; i < static_cast<int>(std::lround(time_s / kStep_s)); ++i) step();
  }

  Bridge bridge;
  Bridge::State state;
  Bridge::Inputs in;
  Bridge::Outputs out;
  Bridge::Events events;
};

// The two routes give the same increment; one as acceleration, the other in the demands.
TEST(Bridge, RoutesGiveTheSameIncrement) {
  Controller tower(params(FeedforwardRoute::TowerDamper)), added(params(FeedforwardRoute::Added));
  for (int i = 0; i < 4000; ++i) {
    const double before_rad = tower.out.increment_rad;
    tower.in.rate_radps = added.in.rate_radps = 0.005 * std::cos(0.01 * i);
    const double x_rad = tower.step().increment_rad;
    ASSERT_EQ(x_rad, added.step().increment_rad);
    ASSERT_NEAR(static_cast<double>(tower.out.tower.fore_aft_mps2),
                (x_rad - before_rad) / (kStep_s * 0.01), 1e-5);
    ASSERT_FLOAT_EQ(added.out.demands[3], static_cast<float>(0.3 + x_rad));
  }
}

// Real accelerations do not count: with the feedforward off the damper gets zeros.
TEST(Bridge, OffSendsZeros) {
  Controller c(params(FeedforwardRoute::TowerDamper));
  c.in.active = 0.0;
  c.in.rate_radps = 0.01;
  EXPECT_EQ(c.step().tower.fore_aft_mps2, 0.0F);
  EXPECT_EQ(c.out.tower.side_side_mps2, 0.0F);
}

// Off, inputs held, or a rate that is no number: faded to exactly zero within FadeTime, without a
// step; a lost rate is said once.
TEST(Bridge, FadesWhateverTurnsItOff) {
  const auto off = [](Bridge::Inputs& in, int how) {
    if (how == 0) in.active = 0.0;
    if (how == 1) in.good = false;
    if (how == 2) in.rate_radps = kNan;
    if (how == 3) in.active = kNan;
  };
  for (int how = 0; how < 4; ++how) {
    Controller c(params(FeedforwardRoute::TowerDamper));
    c.in.rate_radps = 0.004;
    c.steps(20.0);
    off(c.in, how);
    int said = 0;
    for (int i = 0; i < 801; ++i) {
      const double before_rad = c.out.increment_rad;
      EXPECT_LT(before_rad - c.step().increment_rad, 0.1 / 10.0 * kStep_s);
      said += c.events.rate_lost ? 1 : 0;
    }
    EXPECT_EQ(c.out.increment_rad, 0.0);
    EXPECT_EQ(said, how == 2 ? 1 : 0);
  }
}

// While the master holds the demands they stay out of it; then the sum goes on from what was given
// last, within the rate.
TEST(Bridge, HeldDemandsGoOnWithoutAStep) {
  Controller c(params(FeedforwardRoute::Added));
  c.in.rate_radps = 0.004;
  c.steps(20.0);
  const float held_rad = c.out.demands[0];
  c.in.good = false;
  c.in.demands.fill(0.29F);
  c.steps(30.0);
  EXPECT_EQ(c.out.demands[0], 0.29F);
  c.in.good = true;
  c.in.active = 0.0;
  EXPECT_FLOAT_EQ(c.step().demands[0], held_rad - 0.1F * static_cast<float>(kStep_s));
  c.steps(1.0);
  EXPECT_EQ(c.out.demands[0], 0.29F);
}

// Nobody writes the demands: told once, after some patience.
TEST(Bridge, TellsThatNobodyWrites) {
  Controller c(params(FeedforwardRoute::Added));
  c.in.rate_radps = 0.004;
  int told = 0;
  for (int i = 0; i < 4000; ++i) {
    c.in.demands = c.step().demands;
    told += c.events.nobody_writes ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
  EXPECT_NEAR(static_cast<double>(c.out.demands[0]), 0.3 + c.out.increment_rad, 1e-6);
}

// The blades do not show the increment: told once. With an actuator that lags by 0.3 s: not.
TEST(Bridge, TellsThatNobodyFollows) {
  for (const bool follows : {true, false}) {
    Controller c(params(FeedforwardRoute::Added));
    double pitch_rad = 0.3;
    int told = 0;
    for (int i = 0; i < 40000; ++i) {
      c.in.rate_radps = 0.01 * std::cos(0.4 * i * kStep_s);
      const double aim_rad = follows ? static_cast<double>(c.out.demands[0]) : 0.3;
      pitch_rad += (aim_rad - pitch_rad) * kStep_s / 0.3;
      c.in.pitch_rad = pitch_rad;
      c.events = {};
      c.out = c.bridge.step(c.in, c.state, c.events);
      told += c.events.nobody_follows ? 1 : 0;
    }
    EXPECT_EQ(told, follows ? 0 : 1);
  }
}

// A level that is none is refused and said once.
TEST(Bridge, PowerLevel) {
  Controller c(params(FeedforwardRoute::None, DeratingRoute::HubWind));
  c.in.power_level = 0.9;
  c.steps(15.0);
  EXPECT_DOUBLE_EQ(c.out.hub_wind_mps, 18.0);
  c.in.power_level = kNan;
  int said = 0;
  for (int i = 0; i < 1200; ++i) {
    c.step();
    said += c.events.level_lost ? 1 : 0;
  }
  EXPECT_EQ(said, 1);
  EXPECT_DOUBLE_EQ(c.out.hub_wind_mps, 20.0);
}

std::vector<std::byte> saved(Bridge::State& state) {
  std::vector<std::byte> bytes;
  bytes.reserve(4096);  // GCC 12 warns of the growth of an empty vector
  StateArchive archive(bytes);
  archive(state);
  return bytes;
}

// A saved and loaded state goes on to the last bit.
TEST(Bridge, StateContinues) {
  for (const FeedforwardRoute route : {FeedforwardRoute::TowerDamper, FeedforwardRoute::Added}) {
    const BridgeParams p = params(route, DeratingRoute::HubWind);
    Controller c(p);
    const auto disturb = [](Controller& one, int i) -> const Bridge::Outputs& {
      one.in.rate_radps = 0.02 * std::sin(0.02 * i);
      one.in.active = i % 1000 < 700 ? 1.0 : 0.0;
      one.in.power_level = 0.9 + 0.1 * std::sin(0.001 * i);
      one.in.demands.fill(static_cast<float>(0.05 + 0.05 * std::sin(0.013 * i)));
      return one.step();
    };
    for (int i = 0; i < 1900; ++i) disturb(c, i);
    const std::vector<std::byte> bytes = saved(c.state);
    Controller loaded(p);
    loaded.out = c.out;
    StateArchive load{std::span<const std::byte>(bytes)};
    load(loaded.state);
    ASSERT_TRUE(load.complete());
    for (int i = 1900; i < 6000; ++i) {
      const Bridge::Outputs a = disturb(c, i), b = disturb(loaded, i);
      ASSERT_EQ(a.tower.fore_aft_mps2, b.tower.fore_aft_mps2) << i;
      ASSERT_EQ(a.demands, b.demands) << i;
      ASSERT_EQ(a.hub_wind_mps, b.hub_wind_mps) << i;
    }
  }
}

// Steps do not allocate.
TEST(Bridge, DoesNotAllocate) {
  if (!test::kCountsAllocations) GTEST_SKIP() << "malloc is out of reach";
  Controller tower(params(FeedforwardRoute::TowerDamper, DeratingRoute::HubWind));
  Controller added(params(FeedforwardRoute::Added));
  const test::NoAllocGuard guard;
  for (int i = 0; i < 1000; ++i) {
    tower.in.rate_radps = added.in.rate_radps = i % 100 == 0 ? kNan : 0.01;
    tower.step();
    added.step();
  }
  EXPECT_EQ(guard.allocations(), 0U);
}

}  // namespace
}  // namespace lac
