// SPDX-License-Identifier: Apache-2.0
#include "bridge/added_demands.hpp"

#include <gtest/gtest.h>

namespace lac {
namespace {

using Demands = AddedDemands::Demands;

constexpr double kStep_s = 0.1;

Demands all(float rad) {
  return {rad, rad, rad, rad};
}

class AddedDemandsTest : public testing::Test {
 protected:
  /// What becomes of the other's demands.
  Demands step(double increment_rad, Demands demands) {
    limited = added.step(increment_rad, demands, state);
    return demands;
  }

  AddedDemands added{{0.0, 1.5, 0.2}, kStep_s};  // at most 0.02 rad a step
  AddedDemands::State state;
  bool limited = false;
};

// Each blade gets the increment on top of its own demand.
TEST_F(AddedDemandsTest, AddsToEachBlade) {
  const Demands individual = {0.20F, 0.21F, 0.19F, 0.20F};
  step(0.0, individual);
  const Demands sum = step(0.015, individual);
  for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_FLOAT_EQ(sum[i], individual[i] + 0.015F);
  EXPECT_FALSE(limited);
}

// Without an increment nothing is touched, not even what lies outside of the limits.
TEST_F(AddedDemandsTest, WithoutIncrementItPassesAll) {
  for (const float rad : {0.1F, 1.6F, -0.3F, 0.8F}) EXPECT_EQ(step(0.0, all(rad)), all(rad));
  EXPECT_FALSE(limited);
}

// The sum stays within the angles ...
TEST_F(AddedDemandsTest, LimitsTheAngle) {
  step(0.0, all(0.01F));
  EXPECT_EQ(step(-0.05, all(0.01F))[0], 0.0F);
  EXPECT_TRUE(limited);
  state = {};
  step(0.0, all(1.49F));
  EXPECT_FLOAT_EQ(step(0.05, all(1.49F))[0], 1.5F);
  EXPECT_TRUE(limited);
}

// ... and within the rate, whichever of the two moves, until it has caught up.
TEST_F(AddedDemandsTest, LimitsTheRate) {
  step(0.0, all(0.2F));
  EXPECT_FLOAT_EQ(step(0.05, all(0.2F))[0], 0.22F);
  EXPECT_TRUE(limited);
  EXPECT_FLOAT_EQ(step(0.05, all(0.2F))[0], 0.24F);
  EXPECT_FLOAT_EQ(step(0.05, all(0.2F))[0], 0.25F);
  EXPECT_FALSE(limited);
  EXPECT_FLOAT_EQ(step(0.05, all(0.26F))[0], 0.27F);
  EXPECT_FLOAT_EQ(step(0.0, all(0.26F))[0], 0.26F);
  EXPECT_EQ(step(0.0, all(0.26F)), all(0.26F));
}

// After the increment is gone the rest of a limited sum still moves within the rate, and then the
// other's demand passes to the last bit.
TEST_F(AddedDemandsTest, EndsWithTheOthersDemand) {
  step(0.0, all(0.2F));
  for (int i = 0; i < 5; ++i) step(0.08, all(0.2F));
  EXPECT_FLOAT_EQ(step(0.0, all(0.2F))[0], 0.26F);
  for (int i = 0; i < 3; ++i) step(0.0, all(0.2F));
  EXPECT_EQ(step(0.0, all(0.7F)), all(0.7F));
}

// A sum that comes back unwritten is no new demand: nothing piles up, and it is counted.
TEST_F(AddedDemandsTest, DoesNotPileUpOnItself) {
  Demands kept = step(0.0, all(0.2F));
  for (int i = 1; i <= 50; ++i) {
    kept = step(0.01, kept);
    EXPECT_FLOAT_EQ(kept[0], 0.21F);
    EXPECT_EQ(state.not_written, i - 1);
  }
  step(0.01, all(0.205F));
  EXPECT_EQ(state.not_written, 0);
}

// The other's demand may well be the limit the sum is held at: that is no silence.
TEST_F(AddedDemandsTest, ALimitIsNotSilence) {
  step(0.0, all(0.001F));
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(step(-0.01, all(i == 0 ? 0.001F : 0.0F))[0], 0.0F);
    EXPECT_EQ(state.not_written, 0);
  }
  EXPECT_FLOAT_EQ(step(0.01, all(0.0F))[0], 0.01F);
}

}  // namespace
}  // namespace lac
