// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "sim_harness/analysis/lcg_series.hpp"

namespace lac::sim {
namespace {

// Against numpy (std with ddof = 1) for a fixed series.
TEST(Statistics, AgreeWithNumpy) {
  const Statistics found = statistics(test::lcg_series(200));
  EXPECT_NEAR(found.mean, 493.88, 1e-11);
  EXPECT_NEAR(found.standard_deviation, 293.20779261172646, 1e-10);
  EXPECT_EQ(found.min, 4.0);
  EXPECT_EQ(found.max, 998.0);
}

// The run-in leaves no trace, not even in the extremes.
TEST(Statistics, RunInIsDiscarded) {
  const std::vector<double> series{-1000.0, 1000.0, 1.0, 2.0, 3.0, 4.0};
  const Statistics found = statistics(series, 2);
  EXPECT_DOUBLE_EQ(found.mean, 2.5);
  EXPECT_DOUBLE_EQ(found.standard_deviation, std::sqrt(5.0 / 3.0));
  EXPECT_EQ(found.min, 1.0);
  EXPECT_EQ(found.max, 4.0);
  EXPECT_EQ(found.min_sample, 2U);
  EXPECT_EQ(found.max_sample, 5U);
}

// There and back again: 3 + 5 + 2.
TEST(Travel, CountsEveryWay) {
  EXPECT_EQ(travel(std::vector<double>{1.0, 4.0, -1.0, 1.0}), 10.0);
  EXPECT_EQ(travel(std::vector<double>{7.0}), 0.0);
}

// A small deviation beside a large mean keeps its digits.
TEST(Statistics, LargeMeanKeepsDeviation) {
  const std::vector<double> series{5e8 - 1.0, 5e8, 5e8 + 1.0};
  EXPECT_NEAR(statistics(series).standard_deviation, 1.0, 1e-12);
}

// "No value" does not turn into a number.
TEST(Statistics, NanStaysNan) {
  const std::vector<double> series{1.0, std::numeric_limits<double>::quiet_NaN(), 3.0};
  const Statistics found = statistics(series);
  EXPECT_TRUE(std::isnan(found.mean) && std::isnan(found.standard_deviation));
  EXPECT_TRUE(std::isnan(found.min) && std::isnan(found.max));
}

// One sample has no deviation: refused with both numbers.
TEST(Statistics, TooFewSamplesAreRefused) {
  const std::vector<double> series{1.0, 2.0, 3.0};
  EXPECT_THAT([&] { statistics(series, 2); },
              ::testing::ThrowsMessage<Error>(::testing::HasSubstr("has 3, of which the first 2")));
}

}  // namespace
}  // namespace lac::sim
