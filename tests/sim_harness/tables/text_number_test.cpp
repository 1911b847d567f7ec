// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/text_number.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac::sim {
namespace {

// As C, Fortran and spreadsheets write numbers.
TEST(NumberIn, WaysOfWriting) {
  EXPECT_EQ(number_in(" 1.5E+02\t"), 150.0);
  EXPECT_EQ(number_in("+3"), 3.0);
  EXPECT_EQ(number_in("-1.5D+02"), -150.0);
  EXPECT_EQ(number_in("1.5-101"), 1.5e-101);
  EXPECT_EQ(number_in("-1.5+101"), -1.5e101);
  EXPECT_EQ(number_in("-Infinity"), -INFINITY);
}

// No value is not zero.
TEST(NumberIn, NoValue) {
  for (const char* text : {"", "  ", "nan", "NaN", "NA", "n/a"}) {
    ASSERT_TRUE(number_in(text)) << text;
    EXPECT_TRUE(std::isnan(*number_in(text))) << text;
  }
}

// Everything else is no number.
TEST(NumberIn, NotANumber) {
  for (const char* text : {"****", "1.5 2", "1,5", "abc", "1e", "0x10", "--1", "1-", "2013-11-01"})
    EXPECT_FALSE(number_in(text)) << text;
}

// Units of files, shares in reports.
TEST(TextNumber, UnitsAndShares) {
  EXPECT_EQ(without_brackets("(kNm)"), "kNm");
  EXPECT_EQ(without_brackets("[kNm]"), "kNm");
  EXPECT_EQ(without_brackets("kNm"), "kNm");
  EXPECT_EQ(without_brackets(""), "-");
  EXPECT_EQ(percent_text(0.12345, 1), "12.3 %");
}

}  // namespace
}  // namespace lac::sim
