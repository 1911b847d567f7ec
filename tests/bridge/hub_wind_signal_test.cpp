// SPDX-License-Identifier: Apache-2.0
#include "bridge/hub_wind_signal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac {
namespace {

constexpr double kStep_s = 0.1;

// The level moves with its rate and stands for its share of the wind speed of level 1.
TEST(HubWindSignal, FollowsTheLevelWithinTheRate) {
  const HubWindSignal signal({20.0, 1.1, 0.01}, kStep_s);
  HubWindSignal::State s;
  EXPECT_DOUBLE_EQ(signal.step(1.0, 0.0, s), 20.0);
  EXPECT_DOUBLE_EQ(signal.step(0.8, 0.0, s), 20.0 * 0.999);
  for (int i = 0; i < 200; ++i) signal.step(0.8, 0.0, s);
  EXPECT_DOUBLE_EQ(signal.step(0.8, 0.0, s), 16.0);
}

// The cosine of the yaw error, which the reader takes off, is put on; beyond 60 deg no more.
TEST(HubWindSignal, MakesUpForTheYawError) {
  const HubWindSignal signal({}, kStep_s);
  HubWindSignal::State s;
  EXPECT_DOUBLE_EQ(signal.step(1.0, 0.3, s) * std::cos(0.3), 20.0);
  EXPECT_DOUBLE_EQ(signal.step(1.0, -1.4, s), 40.0);
}

// What is no level, or too much, is refused: back to 1, within the rate.
TEST(HubWindSignal, RefusesWhatIsNoLevel) {
  const HubWindSignal signal({20.0, 1.1, 0.01}, kStep_s);
  for (const double bad : {std::nan(""), -0.1, 1.2}) {
    HubWindSignal::State s{0.9, false};
    EXPECT_DOUBLE_EQ(signal.step(bad, 0.0, s), 20.0 * 0.901);
    EXPECT_TRUE(s.refused);
    signal.step(1.1, 0.0, s);
    EXPECT_FALSE(s.refused);
  }
}

}  // namespace
}  // namespace lac
