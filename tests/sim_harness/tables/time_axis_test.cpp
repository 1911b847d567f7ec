// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/time_axis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

void fail(std::size_t row, const std::string& problem) {
  throw Error(std::to_string(row) + ": " + problem);
}

// Times rounded to two decimals still tell a step of 0.0125 s over a whole record.
TEST(TimeAxis, RoundedTimes) {
  std::vector<double> times_s;
  for (int i = 0; i <= 8000; ++i)
    times_s.push_back(std::round(100.0 * (20.0 + 0.0125 * i)) / 100.0);
  const TimeAxis axis = time_axis_of(times_s, fail);
  EXPECT_FALSE(axis.has_gaps());
  EXPECT_EQ(axis.start_s, 20.0);
  EXPECT_EQ(axis.step_s, 0.0125);
}

// Every single missing row is noticed, wherever it is; the axis has a place for it.
TEST(TimeAxis, OneRowMissing) {
  for (std::size_t gone = 1; gone < 20; ++gone) {
    std::vector<double> times_s;
    for (std::size_t i = 0; i <= 20; ++i)
      if (i != gone) times_s.push_back(0.25 * static_cast<double>(i));
    const TimeAxis axis = time_axis_of(times_s, fail);
    ASSERT_TRUE(axis.has_gaps()) << gone;
    EXPECT_EQ(axis.place[gone], gone + 1);
    EXPECT_EQ(axis.place.back(), 20U);
    EXPECT_EQ(axis.step_s, 0.25);
  }
}

// One time has no step: 1 s is given; none is an empty axis.
TEST(TimeAxis, TooFewTimes) {
  EXPECT_EQ(time_axis_of(std::vector<double>{3.0}, fail).start_s, 3.0);
  EXPECT_EQ(time_axis_of(std::vector<double>{3.0}, fail).step_s, 1.0);
  EXPECT_FALSE(time_axis_of({}, fail).has_gaps());
}

// Backwards, standing still, uneven, not finite: the row is named.
TEST(TimeAxis, Faults) {
  const auto error_of = [](std::vector<double> times_s) {
    return test::error_text([&] { time_axis_of(times_s, fail); });
  };
  EXPECT_THAT(error_of({0.0, 1.0, 1.0}), HasSubstr("2: found time 1 s, expected one after 1 s"));
  EXPECT_THAT(error_of({0.0, 1.0, 0.5}), HasSubstr("2: found time 0.5 s"));
  EXPECT_THAT(error_of({0.0, 1.0, 2.0, 3.5, 4.5, 5.5}),
              HasSubstr("3: found a step of 1.5 s, expected a whole number of the usual step"));
  EXPECT_THAT(error_of({0.0, NAN, 2.0}), HasSubstr("1: the time is not a finite number"));
}

}  // namespace
}  // namespace lac::sim
