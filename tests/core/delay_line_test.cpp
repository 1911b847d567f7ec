// SPDX-License-Identifier: Apache-2.0
#include "core/delay_line.hpp"

#include <gtest/gtest.h>

namespace lac {
namespace {

// Delays of whole steps are exact, whatever the delay, up to the longest.
TEST(DelayLine, WholeStepsAreExact) {
  DelayLine line(3.0, 0.0125);
  for (int i = 0; i < 1000; ++i) {
    line.push(static_cast<double>(i) * i);
    for (const int steps : {0, 1, 7, 239, 240}) {
      const double delay_s = steps * 0.0125;
      ASSERT_EQ(line.holds(delay_s), i >= steps);
      if (i >= steps) {
        ASSERT_EQ(line.at(delay_s), static_cast<double>(i - steps) * (i - steps));
      }
    }
  }
}

// In between: on the straight line of its neighbours, exact for a ramp.
TEST(DelayLine, InterpolatesBetweenSteps) {
  DelayLine line(1.0, 0.1);
  for (int i = 0; i < 100; ++i) line.push(0.1 * i);
  EXPECT_NEAR(line.at(0.333), 9.9 - 0.333, 1e-12);
}

// 3.0 s at a step read as a float is 240 steps, not 239.
TEST(DelayLine, RoundingOfTheStepDoesNotLoseOne) {
  const double step_s = static_cast<double>(0.0125f);
  DelayLine line(5.0, step_s);
  for (int i = 0; i <= 300; ++i) line.push(i);
  EXPECT_NEAR(line.at(3.0), 60.0, 1e-5);
}

// What it cannot hold it says: too long, nothing pushed yet, negative.
TEST(DelayLine, RefusesWhatItCannotHold) {
  DelayLine line(1.0, 0.1);
  EXPECT_FALSE(line.holds(0.0));
  for (int i = 0; i < 100; ++i) line.push(i);
  EXPECT_TRUE(line.holds(1.0));
  EXPECT_FALSE(line.holds(1.2));
  EXPECT_FALSE(line.holds(-0.1));
  line.clear();
  EXPECT_FALSE(line.holds(0.0));
}

}  // namespace
}  // namespace lac
