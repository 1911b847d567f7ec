// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/stats_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "sim_harness/tables/csv_table.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class StatsCommandTest : public ::testing::Test {
 protected:
  /// The example of ASTM E1049 as an OpenFAST output of nine seconds.
  std::string astm(const std::string& name) {
    std::string text = "Time TwrBsMyt GenPwr\n(s) (kNm) (kW)\n";
    const int loads[] = {-2, 1, -3, 5, -1, 3, -4, 4, -2};
    for (int i = 0; i < 9; ++i) {
      text.append(std::to_string(i)).append(" ");
      text.append(std::to_string(loads[i])).append(" 3600\n");
    }
    return folder_.write(name, text);
  }
  std::string run(const StatsOptions& o) {
    std::ostringstream out;
    stats_command(o, out);
    return out.str();
  }
  test::TempFolder folder_;
};

// The printed table: extremes with their times, a load by hand (ranges 3, 6, 9 half, 4 one and a
// half, 8 once), energy, and the convention under it.
TEST_F(StatsCommandTest, Table) {
  StatsOptions o;
  o.inputs = {astm("a.out")};
  o.figures.woehler_exponents = {1.0, 4.5};
  const std::string text = run(o);
  EXPECT_THAT(text, HasSubstr("a.out: 9.0000 s\n"));
  EXPECT_THAT(text, HasSubstr("DEL m=1  DEL m=4.50"));
  EXPECT_THAT(text, ::testing::ContainsRegex("TwrBsMyt +kNm +0.11111 .* -4.0000 +6.00 +5.0000 +3.00"
                                             " +2.5556 "));
  EXPECT_THAT(text, ::testing::ContainsRegex("GenPwr +kW +3600.0 .* 9.0000\n"));
  EXPECT_THAT(text, AllOf(HasSubstr("m = 1, R the full range, reference one cycle per second"),
                          HasSubstr("ASTM E1049, residue as half cycles")));
}

// Other conventions are printed and counted.
TEST_F(StatsCommandTest, Conventions) {
  StatsOptions o;
  o.inputs = {astm("a.out")};
  o.channels = {"TwrBsMyt"};
  o.figures.woehler_exponents = {1.0};
  o.figures.counting = RainflowRule::kFourPoint;  // 4 + 3 + 7 + 9
  o.figures.reference = ReferenceCycles::kTwoMillionInTwentyYears;
  const std::string text = run(o);
  EXPECT_THAT(text, HasSubstr("four-point rainflow counting, residue repeated and closed"));
  EXPECT_THAT(text, HasSubstr("2e6 cycles in 20 years"));
  const double cycles = 2e6 * 9.0 / (20.0 * 8760.0 * 3600.0);
  EXPECT_THAT(text, HasSubstr(std::to_string(23.0 / cycles).substr(0, 5)));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("GenPwr")));
}

// The written table: one row per file of a folder, columns of all, empty where a file has none.
TEST_F(StatsCommandTest, CsvOfAFolder) {
  astm("a.out");
  folder_.write("b.csv", "time,GenPwr [kW]\n0,1\n1,3\n");
  StatsOptions o;
  o.inputs = {folder_.path()};
  o.csv = folder_.path("t.csv");
  run(o);
  const CsvTable t(o.csv);
  ASSERT_EQ(t.rows(), 2U);
  EXPECT_EQ(t.number(0, t.column("GenPwr_mean")), 3600.0);
  EXPECT_EQ(t.number(1, t.column("GenPwr_mean [kW]")), 2.0);
  EXPECT_EQ(t.text(1, t.column("TwrBsMyt_del4")), "");
  EXPECT_EQ(t.number(0, t.column("TwrBsMyt_max_time")), 3.0);
  EXPECT_EQ(t.text(1, t.column("file")), folder_.file("b.csv"));
}

// A fault names the file it is in.
TEST_F(StatsCommandTest, Faults) {
  StatsOptions o;
  o.inputs = {astm("a.out")};
  o.channels = {"TwrBsMxt"};
  EXPECT_THAT(test::error_text([&] { run(o); }),
              HasSubstr("a.out: no channel 'TwrBsMxt' (did you mean 'TwrBsMyt'?)"));
  o.channels.clear();
  o.figures.from_s = 20.0;
  EXPECT_THAT(test::error_text([&] { run(o); }), HasSubstr("a.out: fewer than two samples"));
}

// A gap is said, and leaves no figure.
TEST_F(StatsCommandTest, Gaps) {
  StatsOptions o;
  o.inputs = {folder_.write("a.csv", "time,a\n0,1\n1,2\n3,2\n4,3\n")};
  EXPECT_THAT(test::error_text([&] { run(o); }), HasSubstr("a.csv:4: rows are missing"));
  o.missing_rows = MissingRows::kNotNumbers;
  EXPECT_THAT(run(o), HasSubstr("a: no figures, 1 samples are not finite"));
}

}  // namespace
}  // namespace lac::sim
