// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/operating_mode.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"

namespace lac::sim {
namespace {

ModeRule rule() {
  ModeRule r;
  r.rated_power = 5000.0;
  return r;
}

// By pitch and power, with the margins.
TEST(OperatingMode, AtOneInstant) {
  EXPECT_EQ(rule().at(5000.0, 4.0), OperatingMode::kAboveRated);
  EXPECT_EQ(rule().at(4900.0, 0.9), OperatingMode::kBelowRated);
  EXPECT_EQ(rule().at(50.0, 0.0), OperatingMode::kNotProducing);
  EXPECT_EQ(rule().at(NAN, 0.0), OperatingMode::kNotProducing);
  EXPECT_STREQ(text_of(OperatingMode::kAboveRated), "above rated");
}

// A window is what 95 % of it are, else mixed.
TEST(OperatingMode, OfAWindow) {
  const std::vector<double> power(20, 5000.0);
  std::vector<double> pitch(20, 5.0);
  pitch[3] = 0.0;
  EXPECT_EQ(rule().of(power, pitch), OperatingMode::kAboveRated);
  pitch[4] = 0.0;
  EXPECT_EQ(rule().of(power, pitch), OperatingMode::kMixed);
  EXPECT_THAT(test::error_text([&] { rule().of(power, std::vector<double>{}); }),
              ::testing::HasSubstr("20 powers and 0 pitch angles"));
}

// Runs in one mode end at a change, at a gap and at the end; short ones are left out.
TEST(OperatingMode, Stretches) {
  const std::vector<double> power(12, 5000.0), x(12, 8.0);
  const std::vector<double> pitch{5, 5, 0, 5, 5, 5, 5, 5, 5, 5, 5, 5};
  std::vector<double> y(12, 1.0);
  y[6] = NAN;
  const auto found = stretches_in(OperatingMode::kAboveRated, rule(), power, pitch, x, y, 3);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].first, 3U);
  EXPECT_EQ(found[0].length, 3U);
  EXPECT_EQ(found[1].first, 7U);
  EXPECT_EQ(found[1].length, 5U);
}

}  // namespace
}  // namespace lac::sim
