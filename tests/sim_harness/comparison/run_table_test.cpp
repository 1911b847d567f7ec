// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/run_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char kCampaign[] =
    "case,status,reason,mean_speed_mps,seed,controller,GenPwr_mean [kW],TwrBsMyt_del4 [kNm]\n"
    "c1,done,,12,1,fb,4000,100\n"
    "c1,done,,12,1,lac,4010,90\n"
    "c2,failed,\"no, not this\",12,2,,,\n"
    "c3,done,,14,1,fb,5000,120\n"
    "c3,done,,14,1,lac,5000,\n";

// The table of a campaign: rows of one controller, failed ones counted, an empty figure is none.
TEST(RunsOfTable, Campaign) {
  const test::TempFolder folder;
  const CsvTable table(folder.write("t.csv", kCampaign));
  EXPECT_THAT(controllers_in(table, {}), ElementsAre("fb", "lac"));
  const RunTable fb = runs_of_table(table, "fb", {}), lac = runs_of_table(table, "lac", {});
  EXPECT_THAT(fb.figures, ElementsAre("GenPwr_mean [kW]", "TwrBsMyt_del4 [kNm]"));
  ASSERT_EQ(fb.runs.size(), 2U);
  EXPECT_EQ(fb.left_out, 1U);
  EXPECT_EQ(fb.runs[1].wind_mps, 14.0);
  EXPECT_EQ(fb.runs[0].key, lac.runs[0].key);
  EXPECT_NE(fb.runs[0].key, fb.runs[1].key);
  EXPECT_EQ(lac.runs[0].figures[1], 90.0);
  EXPECT_TRUE(std::isnan(lac.runs[1].figures[1]));
}

// Only the rows that are asked for; what is fixed then does not pair.
TEST(RunsOfTable, Conditions) {
  const test::TempFolder folder;
  const CsvTable table(folder.write("t.csv", kCampaign));
  RunTableOptions o;
  o.where = {"mean_speed_mps=14"};
  const RunTable runs = runs_of_table(table, "lac", o);
  ASSERT_EQ(runs.runs.size(), 1U);
  EXPECT_EQ(runs.runs[0].key, "");
  EXPECT_EQ(runs.left_out, 0U);
  o.where = {"mean_speed_mps=15"};
  EXPECT_THAT(test::error_text([&] { runs_of_table(table, "lac", o); }),
              HasSubstr("t.csv: no row has mean_speed_mps=15"));
  o.where = {"seed"};
  EXPECT_THAT(test::error_text([&] { runs_of_table(table, "lac", o); }),
              HasSubstr("expected COLUMN=VALUE"));
}

// What belongs to the controller does not tell winds apart: here its input file.
TEST(RunsOfTable, ParametersOfTheController) {
  const test::TempFolder folder;
  const CsvTable table(folder.write("t.csv",
                                    "case,mean_speed_mps,seed,input,controller,x [-]\n"
                                    "c1,12,1,a.IN,fb,1\nc2,12,2,a.IN,fb,2\n"
                                    "c3,12,1,b.IN,lac,3\nc4,12,2,b.IN,lac,4\n"));
  EXPECT_EQ(runs_of_table(table, "fb", {}).runs[1].key, "seed=2;");
  EXPECT_EQ(runs_of_table(table, "lac", {}).runs[1].key, "seed=2;");
}

// A table of `lac stats`: the file's name pairs, the measured wind falls into bins.
TEST(RunsOfTable, Stats) {
  const test::TempFolder folder;
  const CsvTable table(folder.write("t.csv",
                                    "file,WindHubVelH_mean [m/s],x_mean [-]\nA/s1.outb,13.2,1\n"
                                    "A/s2.outb,12.9,2\n"));
  EXPECT_TRUE(controllers_in(table, {}).empty());
  const RunTable runs = runs_of_table(table, "", {});
  EXPECT_EQ(runs.runs[0].wind_mps, 14.0);
  EXPECT_EQ(runs.runs[1].wind_mps, 12.0);
  EXPECT_EQ(runs.runs[0].key, "file=s1;");
  RunTableOptions o;
  o.bin_mps = 0.5;
  EXPECT_EQ(runs_of_table(table, "", o).runs[0].wind_mps, 13.0);
}

// Two rows of one key, no wind speed, a word for a number.
TEST(RunsOfTable, Faults) {
  const test::TempFolder folder;
  const CsvTable table(folder.write("t.csv", kCampaign));
  RunTableOptions by_seed;
  by_seed.pair_by = {"seed"};
  EXPECT_THAT(test::error_text([&] { runs_of_table(table, "fb", by_seed); }),
              HasSubstr("t.csv:5: has the same parameters as "));
  const CsvTable calm(folder.write("u.csv", "seed,x [m]\n1,2\n"));
  EXPECT_THAT(test::error_text([&] { runs_of_table(calm, "", {}); }),
              HasSubstr("u.csv: has no mean wind speed"));
  const CsvTable word(folder.write("v.csv", "mean_speed_mps,x [m]\n12,many\n"));
  EXPECT_THAT(test::error_text([&] { runs_of_table(word, "", {}); }),
              HasSubstr("v.csv:2: column 'x [m]': found 'many', expected a number"));
}

// An empty cell is no wind speed.
TEST(RunsOfTable, WindMissing) {
  const test::TempFolder folder;
  const CsvTable table(folder.write("t.csv", "mean_speed_mps,seed,x [m]\n12,1,2\n,2,2\n"));
  EXPECT_THAT(
      test::error_text([&] { runs_of_table(table, "", {}); }),
      HasSubstr("t.csv:3: column 'mean_speed_mps': found '', expected the wind speed of the run"));
}

// What the loads are stands in two columns, the same for all runs, and does not pair.
TEST(RunsOfTable, ConventionOfLoads) {
  const test::TempFolder folder;
  const auto runs = [&](const std::string& first, const std::string& second) {
    const CsvTable table(
        folder.write("t.csv", "mean_speed_mps,seed,del_reference,del_rainflow,x_del4 [m]\n12,1," +
                                  first + ",2\n12,2," + second + ",2\n"));
    return runs_of_table(table, "", {});
  };
  const RunTable known = runs("2e6in20y,four-point", "2e6in20y,four-point");
  EXPECT_EQ(known.del_rule,
            (DelRule{ReferenceCycles::kTwoMillionInTwentyYears, RainflowRule::kFourPoint}));
  EXPECT_EQ(known.runs[0].key, "seed=1;");
  EXPECT_FALSE(runs(",", ",").del_rule);
  EXPECT_THAT(test::error_text([&] { runs("1hz,astm", "2e6in20y,astm"); }),
              HasSubstr("t.csv:3: its damage-equivalent loads are of another convention than"));
  EXPECT_THAT(test::error_text([&] { runs("2hz,astm", "2hz,astm"); }),
              HasSubstr("found '2hz', 'astm', expected 1hz or 2e6in20y"));
}

// Two controllers in one folder flew in one wind, not in two.
TEST(RunsOfFolder, OneWindEach) {
  const test::TempFolder folder;
  const std::string names = "time,RtVAvgxh [m/s],GenPwr [kW]\n";
  folder.write("fb.csv", names + "0,11.5,4000\n1,12.5,4100\n");
  folder.write("other.csv", names + "0,11.5,4000\n1,12.4,4100\n");
  EXPECT_EQ(runs_of_folder(folder.path(), {}, {}).runs.size(), 2U);
  folder.write("lac.csv", names + "0,11.5,4010\n1,12.5,4090\n");
  EXPECT_THAT(test::error_text([&] { runs_of_folder(folder.path(), {}, {}); }),
              HasSubstr("lac.csv: has the same wind (RtVAvgxh) as " + folder.file("fb.csv") +
                        ": in a folder one file is one wind"));
}

// A folder of time series: its name, keys from the files, figures computed.
TEST(RunsOfFolder, TimeSeries) {
  const test::TempFolder folder;
  folder.write("s1.csv", "time,Wind1VelX [m/s],GenPwr [kW]\n0,11.5,4000\n1,11.9,4100\n");
  folder.write("s1.lac.csv", "time,LidarRews [m/s]\n0,11\n1,12\n");
  const RunTable runs = runs_of_folder(folder.path(), {}, {});
  EXPECT_EQ(runs.name, folder.path().filename().string());
  ASSERT_EQ(runs.runs.size(), 1U);
  EXPECT_EQ(runs.runs[0].key, "s1");
  EXPECT_EQ(runs.runs[0].wind_mps, 12.0);
  EXPECT_EQ(runs.figures[0], "Wind1VelX_mean [m/s]");
  EXPECT_NEAR(runs.runs[0].figures[0], 11.7, 1e-6);
  folder.write("s2.csv", "time,GenPwr [kW]\n0,4000\n1,4100\n");
  EXPECT_THAT(test::error_text([&] { runs_of_folder(folder.path(), {}, {}); }),
              HasSubstr("s2.csv: has no mean wind speed"));
}

}  // namespace
}  // namespace lac::sim
