// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/text_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace lac::sim {
namespace {

// The whole text: words left, numbers right, two-byte characters count once.
TEST(TextTable, AlignsColumns) {
  TextTable table({"Quantity", "Unit", "Lidar"});
  table.add_row({"Rotor speed", "rpm", "12.10"});
  table.add_row({"Yaw", "°", "-3.00"});
  EXPECT_EQ(table.text(),
            "Quantity     Unit  Lidar\n"
            "------------------------\n"
            "Rotor speed  rpm   12.10\n"
            "Yaw          °     -3.00\n");
}

// A row of another length is a mistake of the caller.
TEST(TextTable, WrongNumberOfCellsIsRefused) {
  TextTable table({"A", "B"});
  EXPECT_THAT([&] { table.add_row({"1"}); },
              ::testing::ThrowsMessage<Error>(::testing::HasSubstr("1 cells, expected 2")));
}

// Signs, decimals, and no number where there is none.
TEST(FormatNumbers, ValuesAndChanges) {
  EXPECT_EQ(format_value(3.14159, 2), "3.14");
  EXPECT_EQ(format_value(std::numeric_limits<double>::quiet_NaN(), 2), "n/a");
  EXPECT_EQ(format_change(0.1234), "+12.3 %");
  EXPECT_EQ(format_change(-0.4), "-40.0 %");
  EXPECT_EQ(format_change(-0.0021), "-0.21 %");
  EXPECT_EQ(format_change(-0.00001), "0.00 %");
  EXPECT_EQ(format_change(std::numeric_limits<double>::infinity()), "n/a");
}

// Digits that count, whatever the size.
TEST(FormatSignificant, LargeAndSmall) {
  EXPECT_EQ(format_significant(1234567.8, 5), "1234568");
  EXPECT_EQ(format_significant(-12.34567, 5), "-12.346");
  EXPECT_EQ(format_significant(0.00123456, 5), "0.0012346");
  EXPECT_EQ(format_significant(0.0, 5), "0");
  EXPECT_EQ(format_significant(std::nan(""), 5), "n/a");
}

}  // namespace
}  // namespace lac::sim
