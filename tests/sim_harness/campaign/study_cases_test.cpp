// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/study_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim_harness/campaign/study_folder.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

class StudyCasesTest : public ::testing::Test {
 protected:
  Study load(const std::string& lines) { return load_study(files_.study(lines)); }
  std::vector<StudyCase> cases(const std::string& lines) { return study_cases(load(lines)); }
  std::string error(const std::string& lines) {
    return test::error_text([&] {
      const Study study = load(lines);
      std::vector<StudyCase> all = study_cases(study);
      check_cases(study, all);
    });
  }
  std::vector<std::string> names(const std::string& lines) {
    std::vector<std::string> all;
    for (const StudyCase& c : cases(lines)) all.push_back(c.name);
    return all;
  }

  test::StudyFolder files_;
};

// All combinations, the last range fastest, less the excluded ones.
TEST_F(StudyCasesTest, Combinations) {
  EXPECT_THAT(names("ranges: {wind.speed_mps: [12, 14], kind: {a: {}, b: {seed: 2}}}\n"),
              ElementsAre("speed_mps-12_a", "speed_mps-12_b", "speed_mps-14_a", "speed_mps-14_b"));
  EXPECT_THAT(names("ranges: {seed: [1, 2, 3], kind: {a: {}, b: {}}}\n"
                    "exclude: [{seed: [1, 2], kind: b}, {seed: 3}]\n"),
              ElementsAre("seed-1_a", "seed-2_a"));
}

// Settings of all cases first, then those of the ranges in their order.
TEST_F(StudyCasesTest, Overrides) {
  const auto all = cases(
      "set: {time.duration_s: 30}\n"
      "ranges: {seed: [7], kind: {a: {wind.speed_mps: 9, wind.shear_exponent: 0.2}}}\n");
  EXPECT_THAT(all[0].overrides, ElementsAre("time.duration_s=30", "seed=7", "wind.speed_mps=9",
                                            "wind.shear_exponent=0.2"));
  EXPECT_EQ(all[0].folder, std::filesystem::path("results/study/cases/seed-7_a"));
}

// Cases that differ in controllers, outputs and the lidar's faults alone share their wind; in
// frozen wind also those with another lidar, in evolving wind not.
TEST_F(StudyCasesTest, SharedWind) {
  const std::string ranges =
      "ranges:\n"
      "  seed: [1, 2]\n"
      "  rest: {a: {outputs.outb: no}, b: {lidar.fault: {kind: dead}}, c: {lidar.tilt_deg: 1}}\n";
  const std::string lidar =
      "set: {lidar: {beam_azimuth_deg: [0], beam_elevation_deg: [0], "
      "gates_m: [50], gates_along: beam, beam_time_s: 1, fwhm_m: 0}, wind: ";
  const auto winds = [&](const std::string& wind) {
    const Study study = load(lidar + wind + "}\n" + ranges);
    std::vector<StudyCase> all = study_cases(study);
    check_cases(study, all);
    return std::vector<bool>{all[0].wind == all[1].wind, all[0].wind == all[2].wind,
                             all[0].wind == all[3].wind};
  };
  EXPECT_THAT(winds("{kind: steady, speed_mps: 9}"), ElementsAre(true, true, false));
  EXPECT_THAT(winds("{kind: mann, mean_speed_mps: 9, evolution: {planes_m: [50]}}"),
              ElementsAre(true, false, false));
}

// A fault of a case is told at the line of the study it comes from.
TEST_F(StudyCasesTest, FaultsOfCases) {
  EXPECT_THAT(error("ranges:\n  wind.sped_mps: [12]\n"),
              EndsWith("study.yaml:3: wind.sped_mps: unknown key (did you mean 'speed_mps'?) (case "
                       "sped_mps-12)"));
  EXPECT_THAT(error("ranges:\n  seed: [1, -2]\n"),
              HasSubstr("study.yaml:3: seed: found -2, expected"));
  EXPECT_THAT(error("set:\n  outputs.html: maybe\nranges: {seed: [1]}\n"),
              HasSubstr("study.yaml:3: outputs.html: found 'maybe', expected true or false"));
  EXPECT_THAT(error("ranges:\n  a:\n    b:\n      controllers.0.input: none.in\n"),
              HasSubstr("study.yaml:5: controllers.0.input: "));
  files_.folder.write("case.yaml", "turbine: none.yaml\n");
  EXPECT_THAT(error("ranges: {seed: [1]}\n"),
              AllOf(HasSubstr("case.yaml:1: turbine: "), HasSubstr("(case seed-1 of ")));
}

// A key in two places, one place that wipes out another, and the folders of the campaign.
TEST_F(StudyCasesTest, FaultsOfKeys) {
  EXPECT_THAT(error("set:\n  seed: 1\nranges:\n  seed: [1]\n"),
              HasSubstr("study.yaml:5: ranges.seed: would replace seed, which line 3 sets"));
  EXPECT_THAT(error("ranges:\n  wind.speed_mps: [1]\n  a:\n    b: {wind: {kind: steady}}\n"),
              HasSubstr("study.yaml:5: ranges.a.wind: would replace wind.speed_mps, which line 3"));
  EXPECT_EQ(error("ranges:\n  a:\n    b: {wind: {kind: steady}}\n  wind.speed_mps: [9]\n"),
            "no error");
  EXPECT_THAT(
      error("ranges:\n  outputs.folder: [here]\n"),
      HasSubstr("study.yaml:3: ranges.outputs.folder: a campaign gives each case a folder"));
  EXPECT_THAT(error("ranges: {a: {x_y: {}, x: {}}, b: {z: {}, y_z: {}}}\n"),
              HasSubstr("two cases are named 'x_y_z'"));
  EXPECT_THAT(error("ranges: {seed: [1]}\nexclude: [{seed: 1}]\n"),
              HasSubstr("exclude: leaves out every case"));
  EXPECT_THAT(error("ranges:\n  seed: {from: 1, to: 99000, step: 1}\n  a: {b: {}, c: {}}\n"),
              HasSubstr("ranges: found more than 100000 cases"));
}

// The command is one line for a shell, quoted where it must be.
TEST_F(StudyCasesTest, CommandLine) {
  const Study study = load(
      "folder: /out put\n"
      "ranges: {a: {b: {controllers: [{name: it's, input: x.in}]}}}\n");
  EXPECT_EQ(command_line(study, study_cases(study)[0], "/bin/lac"),
            "/bin/lac run " + files_.folder.file("case.yaml") +
                " --set 'controllers=[{name: it'\\''s, input: x.in}]' --output '/out put/cases/b' "
                "--mark");
}

}  // namespace
}  // namespace lac::sim
