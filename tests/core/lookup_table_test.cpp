// SPDX-License-Identifier: Apache-2.0
#include "core/lookup_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/error_text.hpp"

namespace lac {
namespace {

using testing::AllOf;
using testing::HasSubstr;

LookupTable read(const std::string& text) {
  InputFile in = InputFile::parse(text, "test.IN");
  return read_table(in, "Wind", "Pitch", 2.0, Range::not_negative());
}

std::string error_of(const std::string& text) {
  return test::error_text([&] { read(text); });
}

// Straight lines between the points, the points themselves, constant outside.
TEST(LookupTable, InterpolatesAndHoldsTheEnds) {
  const LookupTable table({1.0, 2.0, 4.0}, {10.0, 20.0, 0.0});
  EXPECT_DOUBLE_EQ(table.at(1.25), 12.5);
  EXPECT_DOUBLE_EQ(table.at(3.0), 10.0);
  EXPECT_DOUBLE_EQ(table.at(1.0), 10.0);
  EXPECT_DOUBLE_EQ(table.at(2.0), 20.0);
  EXPECT_DOUBLE_EQ(table.at(4.0), 0.0);
  EXPECT_DOUBLE_EQ(table.at(-5.0), 10.0);
  EXPECT_DOUBLE_EQ(table.at(99.0), 0.0);
}

// Slope of each interval; none outside.
TEST(LookupTable, GivesTheSlope) {
  const LookupTable table({1.0, 2.0, 4.0}, {10.0, 20.0, 0.0});
  EXPECT_DOUBLE_EQ(table.slope(1.5), 10.0);
  EXPECT_DOUBLE_EQ(table.slope(3.0), -10.0);
  EXPECT_EQ(table.slope(0.5), 0.0);
  EXPECT_EQ(table.slope(4.5), 0.0);
}

// One point is a constant.
TEST(LookupTable, OnePointIsAConstant) {
  const LookupTable table({5.0}, {3.0});
  for (const double x : {-1.0, 5.0, 9.0}) {
    EXPECT_EQ(table.at(x), 3.0);
    EXPECT_EQ(table.slope(x), 0.0);
  }
  EXPECT_FALSE(table.empty());
  EXPECT_TRUE(LookupTable().empty());
}

// Two rows of an input file; the second is scaled.
TEST(LookupTable, ReadsTwoRows) {
  const LookupTable table = read("10 12 ! Wind - x [m/s]\n0 3 ! Pitch - y [deg]\n");
  EXPECT_DOUBLE_EQ(table.at(11.0), 3.0);
}

// A falling row, a missing value and a value out of range are named with file, line and key.
TEST(LookupTable, NamesFaults) {
  EXPECT_THAT(error_of("10 10 ! Wind - x\n0 3 ! Pitch - y\n"),
              AllOf(HasSubstr("test.IN:1: Wind"), HasSubstr("value 2"), HasSubstr("rising")));
  EXPECT_THAT(error_of("10 12 ! Wind - x\n0 ! Pitch - y\n"),
              AllOf(HasSubstr("test.IN:2: Pitch"), HasSubstr("1 values"), HasSubstr("2")));
  EXPECT_THAT(error_of("10 12 ! Wind - x\n0 -3 ! Pitch - y\n"),
              AllOf(HasSubstr("test.IN:2: Pitch"), HasSubstr("-3")));
}

}  // namespace
}  // namespace lac
