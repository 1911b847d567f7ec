// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/power_level.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac {
namespace {

const double kUnknown = std::nan("");

// S20 eq. 9 with the paper's figures: limits, rated point and slope.
TEST(PowerLevel, Equation9) {
  const PowerLevelParams p;
  EXPECT_DOUBLE_EQ(power_level_for(0.16, p), 1.0);
  EXPECT_DOUBLE_EQ(power_level_for(0.24, p), 0.5);
  EXPECT_DOUBLE_EQ(power_level_for(0.32, p), 0.0);
  EXPECT_DOUBLE_EQ(power_level_for(0.50, p), 0.0);
  EXPECT_NEAR(power_level_for(0.144, p), 1.1, 1e-12);
  EXPECT_DOUBLE_EQ(power_level_for(0.05, p), 1.1);
}

// Nothing known: 1, and not valid.
TEST(PowerLevel, UnknownIsOneAndInvalid) {
  PowerLevel level;
  level.set_intensity(kUnknown, {});
  level.step(0.005, 0.0125);
  EXPECT_EQ(level.level(), 1.0);
  EXPECT_FALSE(level.valid());
}

// The first estimate makes no step: the level leaves 1 at the rate and arrives at eq. 9.
TEST(PowerLevel, FadesInAtTheRate) {
  PowerLevel level;
  const PowerLevelParams p;
  double before = 1.0;
  level.set_intensity(0.24, p);
  for (int i = 0; i < 8100; ++i) {
    level.step(p.rate_1ps, 0.0125);
    EXPECT_TRUE(level.valid());
    EXPECT_LE(before - level.level(), p.rate_1ps * 0.0125 * (1.0 + 1e-9));
    before = level.level();
    if (i == 3999) {
      EXPECT_NEAR(before, 1.0 - 50.0 * p.rate_1ps, 1e-9);
    }
  }
  EXPECT_DOUBLE_EQ(level.level(), 0.5);
}

// A lost estimate fades back; the level stays valid until it is 1 again, so that a reader that
// takes 1 for an invalid level sees no step either.
TEST(PowerLevel, FadesBackBeforeItTurnsInvalid) {
  PowerLevel level;
  const PowerLevelParams p;
  level.set_intensity(0.30, p);
  for (int i = 0; i < 8100; ++i) level.step(p.rate_1ps, 0.0125);
  level.set_intensity(kUnknown, p);
  int valid_steps = 0;
  for (double before = level.level(); level.valid() && valid_steps < 20000; ++valid_steps) {
    level.step(p.rate_1ps, 0.0125);
    EXPECT_LE(level.level() - before, p.rate_1ps * 0.0125 * (1.0 + 1e-9));
    before = level.level();
  }
  EXPECT_NEAR(valid_steps, 8100, 1);  // as long as the way down
  EXPECT_EQ(level.level(), 1.0);
}

}  // namespace
}  // namespace lac
