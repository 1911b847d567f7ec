// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/quality.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Limits, missing and stuck values are counted once each; the good ones stay as they are.
TEST(Clean, CountsEachReason) {
  std::vector<double> v{1, 99, NAN, 2, 5, 5, 5, 5, 3, INFINITY, -7, 4, 4};
  const QualityCount c = clean(v, 1.0, {0.0, 35.0, 2.0, 0.0});
  EXPECT_EQ(c.samples, 13U);
  EXPECT_EQ(c.missing, 2U);
  EXPECT_EQ(c.outside, 2U);
  EXPECT_EQ(c.stuck, 4U);  // four equal samples span 3 s; the two fours span 1 s
  EXPECT_EQ(c.left, 8U);
  EXPECT_EQ(c.gaps_left, 3U);
  EXPECT_NEAR(c.availability(), 5.0 / 13.0, 1e-15);
  EXPECT_EQ(v[0], 1.0);
  EXPECT_EQ(v[8], 3.0);
  EXPECT_TRUE(std::isnan(v[1]) && std::isnan(v[4]) && std::isnan(v[10]));
}

// Gaps of two samples are filled on a line, one of three and those at the ends are not.
TEST(Clean, FillsShortGaps) {
  std::vector<double> v{NAN, 1, NAN, NAN, 7, NAN, NAN, NAN, 8, NAN};
  const QualityCount c = clean(v, 0.25, {.fill_s = 0.5});
  EXPECT_EQ(c.gaps_filled, 1U);
  EXPECT_EQ(c.filled, 2U);
  EXPECT_EQ(c.gaps_left, 3U);
  EXPECT_EQ(c.left, 5U);
  EXPECT_DOUBLE_EQ(v[2], 3.0);
  EXPECT_DOUBLE_EQ(v[3], 5.0);
  EXPECT_TRUE(std::isnan(v[0]) && std::isnan(v[6]) && std::isnan(v[9]));
  EXPECT_THAT(c.text(), HasSubstr("10 samples: 7 missing, 0 outside"));
  EXPECT_NEAR(c.availability(), 0.3, 1e-15);  // filling makes no data
}

// Without rules nothing changes.
TEST(Clean, LeavesGoodDataAlone) {
  std::vector<double> v{1, 1, 1, -500};
  EXPECT_EQ(clean(v, 1.0, {}).availability(), 1.0);
  EXPECT_THAT(v, ElementsAre(1, 1, 1, -500));
}

// Line-of-sight speeds with a CNR out of range, or without one, go.
TEST(DropByCompanion, CarrierToNoise) {
  std::vector<double> v{5, 6, NAN, 7, 8};
  EXPECT_EQ(drop_by_companion(v, std::vector<double>{-10, -20, -30, 1, NAN}, -17.0, 0.0), 3U);
  EXPECT_EQ(v[0], 5.0);
  EXPECT_TRUE(std::isnan(v[1]) && std::isnan(v[3]) && std::isnan(v[4]));
  EXPECT_THAT(test::error_text([&] { drop_by_companion(v, std::vector<double>{1}, 0, 1); }),
              HasSubstr("5 samples with 1 of their companion"));
}

}  // namespace
}  // namespace lac::sim
