// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/run_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/error.hpp"
#include "sim_harness/run/probe_case.hpp"
#include "sim_harness/tables/outb_reader.hpp"
#include "sim_harness/wind/field_file.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RunCaseTest : public ::testing::Test {
 protected:
  CaseResult run(const std::vector<std::string>& overrides = {}) {
    return run_case(load_case(files_.file(), overrides), out_);
  }

  test::ProbeCase files_;
  std::ostringstream out_;
};

// One table and, per controller, .outb and CSV, and one page.
TEST_F(RunCaseTest, WritesItsFiles) {
  const CaseResult result = run();
  EXPECT_EQ(result.figures.size(), 2U);
  EXPECT_EQ(result.files.size(), 5U);
  for (const char* name : {"first.outb", "first.csv", "second.outb", "second.csv", "case.html"}) {
    EXPECT_TRUE(fs::exists(files_.folder.path() / "results" / name)) << name;
  }
  EXPECT_THAT(out_.str(), HasSubstr("Rotor speed, standard deviation"));
  EXPECT_THAT(out_.str(), HasSubstr("change"));
  EXPECT_THAT(files_.folder.read("results/first.csv"),
              HasSubstr("Time [s],RtVAvgxh [m/s],WindHubVelH [m/s],RotSpeed [rpm]"));
}

TEST_F(RunCaseTest, OnlyTheFilesThatAreAskedFor) {
  run({"outputs.csv=no", "outputs.html=no"});
  EXPECT_TRUE(fs::exists(files_.folder.path() / "results/first.outb"));
  EXPECT_FALSE(fs::exists(files_.folder.path() / "results/first.csv"));
  EXPECT_FALSE(fs::exists(files_.folder.path() / "results/case.html"));
}

// What the rotor meets, once for all controllers, when it is asked for.
TEST_F(RunCaseTest, WindChannels) {
  const CaseResult result = run({"outputs.wind=yes", "outputs.wind_window_s=5",
                                 "wind={kind: step, from_mps: 12, to_mps: 14, time_s: 10}"});
  EXPECT_EQ(result.files.size(), 6U);
  const Recording wind = read_outb(files_.folder.path() / "results/case.wind.outb");
  EXPECT_EQ(wind.rows(), 201U);
  EXPECT_NEAR(wind.column("RtVAvgxh")[50], 12.0, 1e-3);
  EXPECT_NEAR(wind.column("WindHubVelX")[150], 14.0, 1e-3);
  EXPECT_NEAR(wind.column("RtTI")[124], std::sqrt(50.0 / 49.0) / 13.0, 1e-4);
}

// The rotor's turbulence intensity beside every flight, and a table, when it is asked for.
TEST_F(RunCaseTest, RotorIntensity) {
  const CaseResult result = run({"outputs.intensity=yes", "outputs.wind_window_s=5",
                                 "wind={kind: step, from_mps: 12, to_mps: 14, time_s: 10}"});
  EXPECT_EQ(result.files.size(), 5U);
  EXPECT_THAT(out_.str(), HasSubstr("standard deviations over 5 s"));
  const Recording flight = read_outb(files_.folder.path() / "results/second.outb");
  EXPECT_NEAR(flight.column("RtTI")[992], std::sqrt(50.0 / 49.0) / 13.0, 1e-4);  // 12.4 s
}

// The same case twice gives the same files, to the last byte: turbulence and lidar on.
TEST_F(RunCaseTest, Deterministic) {
  const std::vector<std::string> overrides{
      "wind={kind: kaimal, mean_speed_mps: 18, period_s: 40, points_across: 15, points_up: 15}",
      "lidar={file: " LAC_SOURCE_DIR "/config/lidars/four_beam_pulsed.yaml}"};
  run(overrides);
  const std::string csv = files_.folder.read("results/second.csv");
  const std::string outb = files_.folder.read("results/first.outb");
  const std::string html = files_.folder.read("results/case.html");
  run(overrides);
  EXPECT_GT(csv.size(), 100000U);
  EXPECT_TRUE(csv == files_.folder.read("results/second.csv"));
  EXPECT_TRUE(outb == files_.folder.read("results/first.outb"));
  EXPECT_TRUE(html == files_.folder.read("results/case.html"));
}

// Wind that repeats itself within the run says so, from a file too; and one that does not is quiet.
TEST_F(RunCaseTest, Repetition) {
  const std::vector<std::string> kaimal{
      "wind={kind: kaimal, mean_speed_mps: 18, period_s: 16, points_across: 9, points_up: 9}"};
  run(kaimal);
  const char* const note =
      "note: the wind repeats itself after its period of 16 s; the run lasts 20";
  EXPECT_THAT(out_.str(), HasSubstr(note));
  const Case c = load_case(files_.file(), kaimal);
  write_field({FieldFormat::kBts, files_.folder.file("f.bts")},
              dynamic_cast<const GriddedWind&>(*make_case_wind(c).field), "");
  const std::string file = "wind={kind: bts, file: " + files_.folder.file("f.bts");
  out_.str("");
  run({file + "}"});
  EXPECT_THAT(out_.str(), HasSubstr(note));
  out_.str("");
  run({file + "}", "time.duration_s=16"});
  EXPECT_THAT(out_.str(), testing::Not(HasSubstr("repeats itself")));
}

// What is wrong with the wind bears the name of the case.
TEST_F(RunCaseTest, WindThatCannotBeMade) {
  EXPECT_THAT(test::error_text([&] {
                run(
                    {"wind={kind: kaimal, mean_speed_mps: 18, period_s: 16, points_across: 9, "
                     "points_up: 9, yaw_deg: 20}"});
              }),
              HasSubstr("case.yaml: wind: turned wind: width left [m]"));
}

// A failing controller is named; what the one before it gave stays.
TEST_F(RunCaseTest, FailingController) {
  files_.folder.write("other.in", "quiet 1\nfail_at 4\n");
  try {
    run();
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("second: controller libtoy_recorder.so ended the run at t = "
                                    "0.05 s: probe: told to fail"));
  }
  EXPECT_TRUE(fs::exists(files_.folder.path() / "results/first.outb"));
  EXPECT_FALSE(fs::exists(files_.folder.path() / "results/second.outb"));
}

// A lidar that looks out of the wind field is refused before the flight.
TEST_F(RunCaseTest, LidarOutsideOfTheField) {
  try {
    run(
        {"wind={kind: kaimal, mean_speed_mps: 18, period_s: 40, points_across: 15, "
         "points_up: 15, width_m: 130}",
         "lidar={file: " LAC_SOURCE_DIR "/config/lidars/four_beam_pulsed.yaml, tilt_deg: 0}"});
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("tilt_deg"));  // keys beside a file are refused
  }
  try {
    run(
        {"wind={kind: kaimal, mean_speed_mps: 18, period_s: 40, points_across: 15, "
         "points_up: 15}",
         "lidar={beam_azimuth_deg: [30], beam_elevation_deg: [0], gates_m: [170], gates_along: "
         "axis, beam_time_s: 0.25, fwhm_m: 30}"});
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("beam 1, gate 1"));
  }
}

}  // namespace
}  // namespace lac::sim
