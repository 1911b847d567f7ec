// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/locked_file.hpp"
#include "sim_harness/campaign/study_folder.hpp"
#include "sim_harness/run/run_case.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "sim_harness/tables/outb_reader.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kTurbulence[] =
    "set:\n"
    "  wind: {kind: kaimal, mean_speed_mps: 18, points_across: 5, points_up: 5, period_s: 30}\n"
    "ranges:\n"
    "  seed: [1, 2]\n"
    "  time.step_s: [0.0125, 0.025]\n"
    "  pitch: {one: {}, two: {controllers.0.name: other}}\n";

class CampaignTest : public ::testing::Test {
 protected:
  /// Status and reason of every row of the table.
  std::string states() {
    const CsvTable table(files_.folder.path("results/results.csv"));
    std::string all;
    for (std::size_t row = 0; row < table.rows(); ++row)
      all += table.text(row, table.column("case")) + " " + table.text(row, table.column("status")) +
             " " + table.text(row, table.column("reason")) + "\n";
    return all;
  }
  std::string bytes(const std::string& name) { return files_.folder.read(name); }

  test::StudyFolder files_;
};

// The same table and the same files with one and two processes at a time, and flown alone.
TEST_F(CampaignTest, SameNumbersAloneAndTogether) {
  files_.study(kTurbulence);
  EXPECT_TRUE(files_.fly(1));
  const std::string table = files_.table();
  CampaignOptions two;
  two.jobs = 2;
  two.output = files_.folder.path("two");
  EXPECT_TRUE(files_.fly(two));
  EXPECT_EQ(bytes("two/results.csv"), table);

  const std::string name = "cases/seed-2_step_s-0.025_two/other.outb";
  std::ostringstream out;
  Case c = load_case(files_.folder.path("case.yaml"),
                     {"wind={kind: kaimal, mean_speed_mps: 18, points_across: 5, points_up: 5, "
                      "period_s: 30}",
                      "seed=2", "time.step_s=0.025", "controllers.0.name=other"});
  c.outputs.folder = files_.folder.path("alone");
  run_case(c, out);
  ASSERT_FALSE(bytes("alone/other.outb").empty());
  EXPECT_EQ(bytes("alone/other.outb"), bytes("results/" + name));
  EXPECT_EQ(bytes("alone/other.outb"), bytes("two/" + name));
  EXPECT_NE(bytes("alone/other.outb"), bytes("two/cases/seed-1_step_s-0.025_two/other.outb"));
}

// The figures of the table are those of the recorded channels, the run-in left out.
TEST_F(CampaignTest, FiguresAreOfTheRecording) {
  files_.study("ranges: {wind.speed_mps: [16]}\n");
  EXPECT_TRUE(files_.fly(1));
  const CsvTable table(files_.folder.path("results/results.csv"));
  const Recording r = read_outb(files_.folder.path("results/cases/speed_mps-16/toy.outb"));
  const std::vector<double> speed_rpm = r.column("RotSpeed");
  double sum = 0.0;
  for (std::size_t i = 400; i < speed_rpm.size(); ++i) sum += speed_rpm[i];
  EXPECT_NEAR(table.number(0, table.column("RotSpeed_mean")),
              sum / static_cast<double>(speed_rpm.size() - 400), 1e-3);
  EXPECT_EQ(table.number(0, table.column("speed_mps")), 16.0);
  EXPECT_EQ(table.text(0, table.column("controller")), "toy");
}

// Whatever way a case ends, the others of the same wind and of other winds are flown.
TEST_F(CampaignTest, FailuresAreIsolated) {
  files_.study(
      "time_limit_s: 3\n"
      "ranges:\n"
      "  wind.speed_mps: [16, 18]\n"
      "  how:\n"
      "    crash: {controllers.0.input: crash.in}\n"
      "    fly: {}\n"
      "    exit: {controllers.0.input: exit.in}\n"
      "    hang: {controllers.0.input: hang.in}\n"
      "    fail: {controllers.0.input: fail.in}\n"
      "    last: {name: last}\n"
      "exclude: [{wind.speed_mps: 18, how: hang}]\n");
  EXPECT_FALSE(files_.fly(2));
  const std::string text = states();
  EXPECT_THAT(text, HasSubstr("speed_mps-16_crash failed the process ended by signal 6 (Aborted)"));
  EXPECT_THAT(text, HasSubstr("speed_mps-16_exit failed the process ended with exit code 3"));
  EXPECT_THAT(text, HasSubstr("speed_mps-16_hang failed took longer than time_limit_s allows"));
  EXPECT_THAT(text, ContainsRegex("speed_mps-16_fail failed toy: .*the toy had enough"));
  for (const char* name : {"speed_mps-16_fly", "speed_mps-16_last", "speed_mps-18_fly"})
    EXPECT_THAT(text, HasSubstr(std::string(name) + " done \n"));
  EXPECT_THAT(files_.said.str(), HasSubstr("4 of 11 cases done, 7 failed"));
  EXPECT_THAT(bytes("results/cases/speed_mps-16_fly/log.txt"), HasSubstr("toy: done in"));
}

// A wind that cannot be made: its cases say why.
TEST_F(CampaignTest, WindThatCannotBeMade) {
  files_.study(
      "set: {wind: {kind: bts, file: wind.bts}}\n"
      "ranges: {a: {x: {}, y: {name: n}}}\n");
  files_.folder.write("wind.bts", "no wind");
  EXPECT_FALSE(files_.fly(1));
  EXPECT_THAT(states(), ContainsRegex("x failed .*wind.bts.*\ny failed .*wind.bts"));
}

// What is done is not flown again, what failed only when it is asked for.
TEST_F(CampaignTest, GoesOnWhereItWas) {
  files_.study("ranges: {how: {fly: {}, fail: {controllers.0.input: fail.in}}}\n");
  EXPECT_FALSE(files_.fly(1));
  const fs::path done = files_.folder.path("results/cases/fly/done");
  const auto written = fs::last_write_time(done);
  EXPECT_FALSE(files_.fly(1));
  EXPECT_THAT(files_.said.str(), HasSubstr("1 done, 1 failed before, 0 to fly in 0 winds"));
  EXPECT_THAT(files_.said.str(), HasSubstr("--only failed flies them again"));
  fs::remove(files_.folder.path("results/results.csv"));
  CampaignOptions failed;
  failed.only_failed = true;
  EXPECT_FALSE(files_.fly(failed));
  EXPECT_THAT(files_.said.str(), HasSubstr("1 to fly in 1 wind"));
  EXPECT_EQ(fs::last_write_time(done), written);
  EXPECT_THAT(states(), HasSubstr("fail failed"));
}

// Another input: what depends on it counts no longer and is flown again, the rest stays.
TEST_F(CampaignTest, OutdatedIsFlownAgain) {
  files_.folder.write("other.in", "fail");
  files_.study("ranges: {how: {a: {}, b: {controllers.0.input: other.in}}}\n");
  EXPECT_FALSE(files_.fly(1));
  const auto written = fs::last_write_time(files_.folder.path("results/cases/a/done"));
  files_.folder.write("other.in", "fly");
  CampaignOptions list;
  list.list = true;
  EXPECT_TRUE(files_.fly(list));
  EXPECT_EQ(files_.said.str(), "done  a\noutdated  b\n");
  CampaignOptions failed;
  failed.only_failed = true;
  EXPECT_TRUE(files_.fly(failed));
  EXPECT_THAT(files_.said.str(), HasSubstr("note: 1 case there are of other inputs"));
  EXPECT_EQ(states(), "a done \nb done \n");
  EXPECT_EQ(fs::last_write_time(files_.folder.path("results/cases/a/done")), written);
}

// A dry run shows the commands and writes nothing; the list of commands comes before the flights.
TEST_F(CampaignTest, DryRunAndList) {
  files_.study("ranges: {seed: [1, 2]}\n");
  CampaignOptions dry;
  dry.dry_run = true;
  EXPECT_TRUE(files_.fly(dry));
  EXPECT_FALSE(fs::exists(files_.folder.path("results")));
  EXPECT_THAT(files_.said.str(), HasSubstr("2 to fly in 2 winds\n"));
  EXPECT_THAT(files_.said.str(), HasSubstr(" --set seed=2 --output "));
  EXPECT_TRUE(files_.fly(1));
  EXPECT_THAT(bytes("results/cases.txt"),
              ContainsRegex("run .*seed=1 .*--mark\n.*seed=2 .*--mark\n"));
}

// Two controllers: a page with their comparison, unless it is switched off. One: said.
TEST_F(CampaignTest, Report) {
  files_.study(kTurbulence);
  CampaignOptions options;
  options.report = false;
  EXPECT_TRUE(files_.fly(options));
  EXPECT_FALSE(fs::exists(files_.folder.path("results/report.html")));
  options.report = true;
  EXPECT_TRUE(files_.fly(options));
  EXPECT_THAT(files_.said.str(), HasSubstr("wrote " + files_.folder.file("results/report.html")));
  EXPECT_THAT(bytes("results/report.html"), HasSubstr("From A = toy to B = other: all runs"));
  files_.study("ranges: {seed: [1, 2]}\n");
  options.output = files_.folder.path("one");
  EXPECT_TRUE(files_.fly(options));
  EXPECT_THAT(files_.said.str(), HasSubstr("no report: one controller, nothing to compare"));
  EXPECT_FALSE(fs::exists(files_.folder.path("one/report.html")));
}

// Another study does not overwrite the table; the same one goes on.
TEST_F(CampaignTest, FolderOfAnotherStudy) {
  files_.study("ranges: {seed: [1]}\n");
  EXPECT_TRUE(files_.fly(1));
  const std::string table = files_.table();
  files_.folder.write("results/study.txt", "other.yaml\n");
  EXPECT_THAT(test::error_text([&] { files_.fly(1); }),
              HasSubstr("holds the results of study 'other.yaml', not of 'study.yaml'"));
  EXPECT_EQ(files_.table(), table);
  files_.folder.write("results/study.txt", "study.yaml\n");
  EXPECT_TRUE(files_.fly(1));
}

// One campaign at a time in a folder.
TEST_F(CampaignTest, FolderIsLocked) {
  files_.study("ranges: {seed: [1]}\n");
  fs::create_directories(files_.folder.path("results"));
  LockedFile other;
  ASSERT_EQ(other.open(files_.folder.path("results/lock")), 0);
  EXPECT_THAT(test::error_text([&] { files_.fly(1); }),
              HasSubstr("results: another campaign is flying into this folder"));
  other.close();
  EXPECT_TRUE(files_.fly(1));
}

}  // namespace
}  // namespace lac::sim
