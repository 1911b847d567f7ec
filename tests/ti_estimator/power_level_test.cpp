// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/power_level.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac {
namespace {

const double kUnknown = std::nan("");
constexpr double kSpeed_mps = 16.0;

// S20 eq. 9 with the paper's figures: limits, rated point and slope.
TEST(PowerLevel, Equation9) {
  const PowerLevelParams p;
  EXPECT_DOUBLE_EQ(power_level_for(0.16, kSpeed_mps, p), 1.0);
  EXPECT_DOUBLE_EQ(power_level_for(0.24, kSpeed_mps, p), 0.5);
  EXPECT_DOUBLE_EQ(power_level_for(0.32, kSpeed_mps, p), 0.0);
  EXPECT_DOUBLE_EQ(power_level_for(0.50, kSpeed_mps, p), 0.0);
  EXPECT_NEAR(power_level_for(0.144, kSpeed_mps, p), 1.1, 1e-12);
  EXPECT_DOUBLE_EQ(power_level_for(0.05, kSpeed_mps, p), 1.1);
}

// Nothing known: 1, and not valid.
TEST(PowerLevel, UnknownIsOneAndInvalid) {
  PowerLevel level;
  level.set_intensity(kUnknown, kSpeed_mps, {});
  level.step(0.005, 0.0125);
  EXPECT_EQ(level.level(), 1.0);
  EXPECT_FALSE(level.valid());
}

// The first estimate makes no step: the level leaves 1 at the rate and arrives at eq. 9.
TEST(PowerLevel, FadesInAtTheRate) {
  PowerLevel level;
  const PowerLevelParams p;
  double before = 1.0;
  level.set_intensity(0.24, kSpeed_mps, p);
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
  level.set_intensity(0.30, kSpeed_mps, p);
  for (int i = 0; i < 8100; ++i) level.step(p.rate_1ps, 0.0125);
  level.set_intensity(kUnknown, kSpeed_mps, p);
  int valid_steps = 0;
  for (double before = level.level(); level.valid() && valid_steps < 20000; ++valid_steps) {
    level.step(p.rate_1ps, 0.0125);
    EXPECT_LE(level.level() - before, p.rate_1ps * 0.0125 * (1.0 + 1e-9));
    before = level.level();
  }
  EXPECT_NEAR(valid_steps, 8100, 1);  // as long as the way down
  EXPECT_EQ(level.level(), 1.0);
}

// Other figures at other wind speeds, straight lines between.
TEST(PowerLevel, ScheduledOverWindSpeed) {
  PowerLevelParams p;
  p.rated_intensity = LookupTable({12.0, 16.0}, {0.20, 0.16});
  p.zero_intensity = LookupTable({12.0, 16.0}, {0.40, 0.32});
  EXPECT_DOUBLE_EQ(power_level_for(0.20, 12.0, p), 1.0);
  EXPECT_DOUBLE_EQ(power_level_for(0.27, 14.0, p), 0.5);
  EXPECT_DOUBLE_EQ(power_level_for(0.24, 16.0, p), 0.5);
  EXPECT_DOUBLE_EQ(power_level_for(0.24, 25.0, p), 0.5);
}

// Within the deadband the level rests; a lost estimate goes back to 1 all the same.
TEST(PowerLevel, Deadband) {
  PowerLevelParams p;
  p.deadband = 0.05;
  PowerLevel level;
  const auto after = [&](double intensity) {
    level.set_intensity(intensity, kSpeed_mps, p);
    for (int i = 0; i < 10000; ++i) level.step(p.rate_1ps, 0.0125);
    return level.level();
  };
  EXPECT_DOUBLE_EQ(after(0.24), 0.5);
  EXPECT_DOUBLE_EQ(after(0.247), 0.5);
  EXPECT_DOUBLE_EQ(after(0.233), 0.5);
  EXPECT_NEAR(after(0.249), 0.44375, 1e-12);
  EXPECT_NEAR(after(0.242), 0.44375, 1e-12);
  EXPECT_DOUBLE_EQ(after(kUnknown), 1.0);
}

}  // namespace
}  // namespace lac
