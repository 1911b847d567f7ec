// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/text_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char kOut[] =
    "\n"
    "Predictions were generated on 22-Nov-2023 at 10:00:00 using OpenFAST, Time step 0.5\n"
    "linked with NWTC Subroutine Library\n"
    "\n"
    "Description from the FAST input file: a test\n"
    "\n"
    "Time      \tRotSpeed  \tTwrBsMyt  \n"
    "(s)       \t(rpm)     \t(kN-m)    \n"
    "    0.0000\t 1.210E+01\t-3.400E+04\n"
    "    0.5000\t 1.220E+01\t       NaN\n"
    "    1.0000\t 1.230E+01\t-3.2000-05\n"
    "\n";

// OpenFAST's layout: header lines, names, units, tabs; an empty line at the end.
TEST(ReadOut, OpenFastLayout) {
  const test::TempFolder folder;
  const Recording r = read_out(folder.write("a.out", kOut));
  EXPECT_THAT(r.channels(),
              ElementsAre(TableChannel{"RotSpeed", "rpm"}, TableChannel{"TwrBsMyt", "kN-m"}));
  EXPECT_EQ(r.time_step_s(), 0.5);
  EXPECT_THAT(r.column("RotSpeed"), ElementsAre(12.1F, 12.2F, 12.3F));
  EXPECT_TRUE(std::isnan(r.column("TwrBsMyt")[1]));
  EXPECT_EQ(r.column("TwrBsMyt")[2], -3.2e-5F);
}

// Blanks instead of tabs, line ends of Windows, a remark at the end, as HydroDyn writes.
TEST(ReadOut, BlanksAndCarriageReturns) {
  const test::TempFolder folder;
  const Recording r = read_out(folder.write(
      "a.out",
      "\r\n\r\n    Time   Wave1Elev\r\n   (sec)   (m)\r\n 0.0  1.0\r\n 1.0  2.0\r\n\r\n"
      "That was all.\r\n"));
  EXPECT_THAT(r.column("Wave1Elev"), ElementsAre(1.0, 2.0));
  EXPECT_EQ(r.channels()[0].unit, "m");
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

// Each fault names file, line, and what was found and expected.
TEST(ReadOut, Faults) {
  const test::TempFolder folder;
  const auto error_of = [&](const std::string& text) {
    return test::error_text([&] { read_out(folder.write("a.out", text)); });
  };
  EXPECT_THAT(error_of(with(kOut, "\t-3.400E+04", "")),
              HasSubstr("a.out:9: found 2 columns, expected 3 as in the line of names"));
  EXPECT_THAT(
      error_of(with(kOut, " 1.210E+01", "**********")),
      HasSubstr("a.out:9: column 2 (RotSpeed): found '**********', expected a number; stars "
                "stand where one did not fit"));
  EXPECT_THAT(error_of(with(kOut, "\t(kN-m)    ", "")),
              HasSubstr("a.out:8: found 2 units, expected 3"));
  EXPECT_THAT(error_of(with(kOut, "(s) ", "0.0 ")), HasSubstr("a.out:8: expected a line of units"));
  EXPECT_THAT(error_of(with(kOut, "Time      \t", "t \t")),
              HasSubstr("a.out: found no line that begins with 'Time'"));
  EXPECT_THAT(error_of(with(kOut, "    1.0000", "    0.2500")),
              HasSubstr("a.out:11: found time 0.25 s, expected one after 0.5 s"));
  EXPECT_THAT(error_of("Time a\n(s) (-)\n"), HasSubstr("a.out: found no row of numbers"));
  EXPECT_THAT(error_of(std::string("\x04\x00\x0a\x00", 4)),
              HasSubstr("a.out:1: found bytes that are no text"));
  EXPECT_THAT(test::error_text([&] { read_out(folder.path("none.out")); }),
              HasSubstr("none.out: cannot be opened"));
}

// What the harness writes as .csv comes back bit by bit.
TEST(ReadCsv, RoundTrip) {
  const test::TempFolder folder;
  Recording written({{"RotSpeed", "rpm"}, {"LidarRews", "m/s"}}, 1.5, 0.0125, 300);
  for (int i = 0; i < 300; ++i) {
    const float row[] = {static_cast<float>(12.0 + std::sin(0.1 * i)),
                         i % 2 ? 0.1F : std::nanf("")};
    written.append(row);
  }
  written.write(folder.file("a.csv"));
  const Recording read = read_csv(folder.file("a.csv"));
  EXPECT_EQ(read.channels(), written.channels());
  EXPECT_EQ(read.start_time_s(), 1.5);
  EXPECT_EQ(read.time_step_s(), 0.0125);
  ASSERT_EQ(read.rows(), 300U);
  for (std::size_t i = 0; i < 300; ++i) {
    EXPECT_EQ(read.row(i)[0], written.row(i)[0]);
    EXPECT_EQ(std::isnan(read.row(i)[1]), i % 2 == 0);
  }
}

// As spreadsheets and loggers write: byte order mark, comments, quotes, a row of units, semicolons
// with decimal commas, empty cells.
TEST(ReadCsv, ForeignLayouts) {
  const test::TempFolder folder;
  const Recording a = read_csv(folder.write(
      "a.csv",
      "\xEF\xBB\xBF# logger 7\n\"time\";\"v_los (m/s)\";CNR\n[s];[m/s];dB\n0;7,5;-12\n1;;-13\n"));
  EXPECT_THAT(a.channels(), ElementsAre(TableChannel{"v_los", "m/s"}, TableChannel{"CNR", "dB"}));
  EXPECT_EQ(a.column("v_los")[0], 7.5);
  EXPECT_TRUE(std::isnan(a.column("v_los")[1]));
  EXPECT_THAT(a.column("CNR"), ElementsAre(-12.0, -13.0));
  const Recording b = read_csv(folder.write("b.csv", "T\ta\tb\n0\t1\t\n0.5\t2\t3\n"));
  EXPECT_THAT(b.column("a"), ElementsAre(1.0, 2.0));
  EXPECT_TRUE(std::isnan(b.column("b")[0]));
}

// A measurement that paused: refused, or rows of NaN in the gap.
TEST(ReadCsv, MissingRows) {
  const test::TempFolder folder;
  const std::string file = folder.write("a.csv", "time,a\n0,1\n1,2\n4,5\n5,6\n");
  EXPECT_THAT(test::error_text([&] { read_csv(file); }),
              HasSubstr("a.csv:4: rows are missing before this one"));
  const std::vector<double> a = read_csv(file, MissingRows::kNotNumbers).column("a");
  ASSERT_EQ(a.size(), 6U);
  EXPECT_TRUE(std::isnan(a[2]) && std::isnan(a[3]));
  EXPECT_EQ(a[4], 5.0);
}

// Faults of a .csv file.
TEST(ReadCsv, Faults) {
  const test::TempFolder folder;
  const auto error_of = [&](const std::string& text) {
    return test::error_text([&] { read_csv(folder.write("a.csv", text)); });
  };
  EXPECT_THAT(error_of("wind,power\n1,2\n"),
              HasSubstr("a.csv:1: found 'wind' as name of the first column, expected Time [s]"));
  EXPECT_THAT(error_of("time,a\n0,1\n1,2,3\n"), HasSubstr("a.csv:3: found 3 columns, expected 2"));
  EXPECT_THAT(error_of("time,a\n0,1\n1,x\n"),
              HasSubstr("a.csv:3: column 2 (a): found 'x', expected a number"));
  EXPECT_THAT(error_of("time\n0\n"), HasSubstr("a.csv:1: found no name behind the time"));
  EXPECT_THAT(error_of("time,a,a\n0,1,2\n"), HasSubstr("a.csv:1: the name 'a' stands twice"));
  EXPECT_THAT(error_of("# only this\n"), HasSubstr("a.csv: found no line of names"));
}

}  // namespace
}  // namespace lac::sim
