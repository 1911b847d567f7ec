// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/csv_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

// Words, numbers and empty cells; columns by name with and without unit.
TEST(CsvTable, ColumnsAndCells) {
  const test::TempFolder folder;
  const CsvTable t(folder.write(
      "a.csv",
      "case,controller,TwrBsMyt_del4 [kNm]\n1,\"lidar, new\",1.5e4\r\n2,\"a \"\"b\"\"\",\n"));
  ASSERT_EQ(t.rows(), 2U);
  EXPECT_EQ(t.text(0, 1), "lidar, new");
  EXPECT_EQ(t.text(1, 1), "a \"b\"");
  EXPECT_EQ(t.column("TwrBsMyt_del4"), 2U);
  EXPECT_EQ(t.column("TwrBsMyt_del4 [kNm]"), 2U);
  EXPECT_EQ(t.number(0, 2), 15000.0);
  EXPECT_TRUE(std::isnan(t.number(1, 2)));
  EXPECT_EQ(unit_in(t.names()[2]), "kNm");
  EXPECT_EQ(unit_in("case"), "");
}

// Faults with their places.
TEST(CsvTable, Faults) {
  const test::TempFolder folder;
  const auto error_of = [&](const std::string& text) {
    return test::error_text([&] { CsvTable(folder.write("a.csv", text)); });
  };
  EXPECT_THAT(error_of("a,b\n1,2\n3\n"), HasSubstr("a.csv:3: found 1 cells, expected 2"));
  EXPECT_THAT(error_of("a,b\n1,\"2\n3,4\n"), HasSubstr("a.csv:2: a quote is not closed"));
  EXPECT_THAT(error_of("\n"), HasSubstr("a.csv:1: found no names of columns"));
  const CsvTable t(folder.write("b.csv", "seed,power\n1,x\n"));
  EXPECT_THAT(test::error_text([&] { t.number(0, 1); }),
              HasSubstr("b.csv:2: column 'power': found 'x', expected a number"));
  EXPECT_THAT(test::error_text([&] { t.column("sed"); }),
              HasSubstr("b.csv: has no column 'sed' (did you mean 'seed'?)"));
}

// What is written is read: quotes, commas, line feeds, every digit.
TEST(CsvTable, RoundTrip) {
  const test::TempFolder folder;
  const CsvTable t(folder.write("a.csv", csv_line({"name", "x"}) +
                                             csv_line({"a \"b\",\nc", csv_number(0.1 + 0.2)}) +
                                             csv_line({"", csv_number(NAN)})));
  ASSERT_EQ(t.rows(), 2U);
  EXPECT_EQ(t.text(0, 0), "a \"b\",\nc");
  EXPECT_EQ(t.number(0, 1), 0.1 + 0.2);
  EXPECT_TRUE(std::isnan(t.number(1, 1)));
  EXPECT_EQ(t.place(1).substr(t.place(1).rfind(':')), ":4");
}

}  // namespace
}  // namespace lac::sim
