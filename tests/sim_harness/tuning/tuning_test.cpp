// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/tuning.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <sstream>

#include "core/input_file.hpp"
#include "sim_harness/run/interruption.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "sim_harness/tuning/tuning_flights.hpp"
#include "support/environment.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using test::error_text;

/// A study of steady wind at 14 and 16 m/s, IEA 3.4 MW, feedback alone, twice.
class Tune : public ::testing::Test {
 protected:
  Tune() {
    folder_.write("case.yaml",
                  "turbine: " LAC_SOURCE_DIR
                  "/config/turbines/iea3p4mw/turbine.yaml\n"
                  "time: {duration_s: 150, run_in_s: 120, step_s: 0.05}\n"
                  "wind: {kind: steady, speed_mps: 14}\n"
                  "controllers:\n"
                  "  - {name: before, input: " LAC_SOURCE_DIR
                  "/config/iea3p4mw/wrapper_fb.IN}\n"
                  "  - {name: after, input: " LAC_SOURCE_DIR "/config/iea3p4mw/wrapper_fb.IN}\n");
    folder_.write("study.yaml",
                  "case: case.yaml\nranges:\n  wind.speed_mps: [14, 16]\n  shear: {none: {}}\n");
  }

  fs::path tuning(const std::string& lines) const {
    return folder_.write("tuning.yaml",
                         "study: study.yaml\nbaseline: before\ncontroller: after\n"
                         "secondary: feedback\n" +
                             lines);
  }
  std::string refusal(const std::string& lines) const {
    return error_text([&] { load_tuning(tuning(lines)); });
  }

  test::TempFolder folder_;
};

constexpr char kObjective[] = "maximise: {figure: GenPwr_mean}\n";
constexpr char kGrid[] = "parameters: {RatedTorque: {from: 27000, to: 31000, step: 1000}}\n";

// In steady wind above rated the power is proportional to the rated torque: the most of it with a
// torque of at most 5 % more than before is 5 % more, at 1.05 x 28 797.6 Nm = 30 237.5 Nm.
TEST_F(Tune, FindsTheConditionsBorder) {
  TuningOptions options;
  options.file = tuning(std::string(kObjective) + kGrid +
                        "conditions:\n"
                        "  - {figure: GenTq_max, where: {wind.speed_mps: 16}, at_most_percent: 5}\n"
                        "refinements: 20\n");
  options.output_folder = folder_.path("results");
  std::ostringstream out;
  ASSERT_TRUE(run_tuning(options, out)) << out.str();
  InputFile tuned = InputFile::load(folder_.path("results/feedback.IN"));
  EXPECT_NEAR(tuned.number("RatedTorque"), 30237.5, 40.0);
  EXPECT_LE(tuned.number("RatedTorque"), 30238.0);
  EXPECT_EQ(tuned.number("MaximumTorque"), 31677.36);

  const CsvTable table(folder_.path("results/evaluations.csv"));
  ASSERT_GT(table.rows(), 5U);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    EXPECT_NEAR(table.number(i, table.column("GenPwr_mean change")),
                table.number(i, table.column("RatedTorque")) / 28797.6 - 1.0, 2e-4);
  }
}

// A value that the controller refuses is a failed evaluation with its words; the others go on.
TEST_F(Tune, LivesWithRefusedValues) {
  TuningOptions options;
  options.file = tuning(std::string(kObjective) +
                        "parameters: {RatedTorque: [-1, 28000], FinePitch: [1.2]}\n");
  options.output_folder = folder_.path("results");
  std::ostringstream out;
  EXPECT_TRUE(run_tuning(options, out));
  EXPECT_NE(out.str().find("1 failed: case"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("RatedTorque: found -1"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("best: RatedTorque 28000, FinePitch 1.2"), std::string::npos);
}

// Conditions that nothing meets: said, the nearest shown, no input file written, and none left
// of before. Two runs alike, on one core and on two.
TEST_F(Tune, NothingMeetsTheConditions) {
  TuningOptions options;
  options.file = tuning(std::string(kObjective) + kGrid +
                        "conditions: [{figure: GenPwr_mean, at_least_percent: 50}]\n");
  options.output_folder = folder_.path("results");
  options.jobs = 1;
  fs::create_directories(options.output_folder);
  folder_.write("results/feedback.IN", "of yesterday");
  std::ostringstream out;
  EXPECT_FALSE(run_tuning(options, out));
  EXPECT_NE(out.str().find("results/feedback.IN of an earlier tuning"), std::string::npos);
  EXPECT_NE(out.str().find("no parameters meet all conditions; nearest: RatedTorque 31000"),
            std::string::npos)
      << out.str();
  EXPECT_FALSE(fs::exists(folder_.path("results/feedback.IN")));
  const std::string first = folder_.read("results/evaluations.csv");
  options.jobs = 2;
  EXPECT_FALSE(run_tuning(options, out));
  EXPECT_EQ(folder_.read("results/evaluations.csv"), first);
}

// A baseline that keeps its state in static data (the toy would lose it to the flight beside it)
// flies one case after another: with more jobs the same figures.
TEST_F(Tune, BaselineWithStaticData) {
  folder_.write("probe.IN", "pitch_rad 0.2\ntorque_Nm 20000\nquiet 1\n");
  std::string text = folder_.read("case.yaml");
  const std::string line = LAC_SOURCE_DIR "/config/iea3p4mw/wrapper_fb.IN}";
  text.replace(text.find(line), line.size(), "probe.IN, library: " LAC_TOY_DIR "/libtoy_recorder}");
  folder_.write("case.yaml", text);
  TuningOptions options;
  options.file = tuning(std::string("parameters: {RatedTorque: [28000]}\n") +
                        "maximise: {figure: GenTqDem_mean}\n");
  options.output_folder = folder_.path("results");
  options.jobs = 4;
  std::ostringstream out;
  EXPECT_TRUE(run_tuning(options, out));
  EXPECT_NE(out.str().find("GenTqDem_mean: 20.000 -> "), std::string::npos) << out.str();
}

// One controller is tuned, not one by its library here and another there.
TEST_F(Tune, OneLibraryInAllCases) {
  folder_.write("study.yaml",
                "case: case.yaml\nranges:\n  which:\n    one: {}\n    other: {controllers.1.entry: "
                "OTHER}\n");
  TuningOptions options;
  options.file = tuning(std::string(kObjective) + kGrid);
  options.output_folder = folder_.path("results");
  std::ostringstream out;
  EXPECT_NE(error_text([&] { run_tuning(options, out); }).find("library or entry in some of"),
            std::string::npos);
}

// Interrupted when one point of two is through its cases: that one counts, its files are gone.
TEST_F(Tune, InterruptedBetweenPoints) {
  const Tuning t = load_tuning(tuning(std::string(kObjective) + kGrid));
  fs::create_directories(folder_.path("work"));
  const Interruption interruption;
  TuningFlights flights(t, folder_.path("work"), 1, interruption);
  const std::vector<double> baseline = flights.fly_baseline();
  const auto evaluations = flights.fly({{28000.0}, {29000.0}}, baseline, [&](double done) {
    EXPECT_EQ(fs::exists(folder_.path("work/0")), done < 0.5);
    EXPECT_FALSE(fs::exists(folder_.path("work/1")));
    if (done == 0.5) std::raise(SIGINT);
  });
  ASSERT_EQ(evaluations.size(), 1U);
  EXPECT_EQ(evaluations[0].values, Point{28000.0});
  EXPECT_THROW(flights.check(), Interrupted);
}

/// Presses Ctrl-C at the first thing that is said.
struct Impatient : std::stringbuf {
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    if (!pressed) std::raise(SIGINT);
    pressed = true;
    return std::stringbuf::xsputn(text, size);
  }
  bool pressed = false;
};

// An interrupted tuning leaves its table and no temporary folder.
TEST_F(Tune, Interrupted) {
  TuningOptions options;
  options.file = tuning(std::string(kObjective) + kGrid);
  options.output_folder = folder_.path("results");
  fs::create_directories(options.output_folder);
  fs::create_directories(folder_.path("tmp"));
  folder_.write("results/feedback.IN", "of yesterday");
  const test::OtherTemporaryFolder elsewhere(folder_.path("tmp"));
  Impatient said;
  std::ostream out(&said);
  EXPECT_THROW(run_tuning(options, out), sim::Interrupted);
  EXPECT_TRUE(said.pressed);
  EXPECT_EQ(folder_.read("results/evaluations.csv").substr(0, 6), "stage,");
  EXPECT_FALSE(fs::exists(folder_.path("results/feedback.IN")));
  EXPECT_TRUE(fs::is_empty(folder_.path("tmp")));
}

// The grid has four digits, like all that is flown: its border cannot be passed by rounding.
TEST_F(Tune, GridOfFourDigits) {
  const Tuning t = load_tuning(tuning(
      std::string(kObjective) + "parameters: {RatedTorque: [27001, 28797.6, 28803, 30996]}\n"));
  EXPECT_EQ(t.parameters[0].values, (std::vector<double>{27000.0, 28800.0, 31000.0}));
}

// A folder that cannot be made is said before anything flies.
TEST_F(Tune, MakesTheFolderFirst) {
  TuningOptions options;
  options.file = tuning(std::string(kObjective) + kGrid);
  folder_.write("file", "");
  options.output_folder = folder_.path("file/results");
  std::ostringstream out;
  EXPECT_NE(error_text([&] { run_tuning(options, out); }).find("cannot be made"),
            std::string::npos);
  EXPECT_EQ(out.str(), "");
}

// The template is never written over.
TEST_F(Tune, KeepsTheTemplate) {
  TuningOptions options;
  options.file = tuning(std::string(kObjective) + kGrid);
  options.output_folder = LAC_SOURCE_DIR "/config/iea3p4mw";
  std::ostringstream out;
  EXPECT_NE(error_text([&] { run_tuning(options, out); }).find("is not written over"),
            std::string::npos);
}

// Faults of the file, with place and hint.
TEST_F(Tune, Faults) {
  const std::string grid = kGrid, objective = kObjective;
  EXPECT_NE(refusal(grid).find("either minimise or maximise"), std::string::npos);
  EXPECT_NE(refusal(grid + "maximise: {figure: GenPwr_men}\n")
                .find("tuning.yaml:6: maximise.figure: found 'GenPwr_men'"),
            std::string::npos);
  EXPECT_NE(
      refusal(grid + "maximise: {figure: GenPwr_mean, were: {}}\n").find("did you mean 'where'"),
      std::string::npos);
  EXPECT_NE(refusal(grid + "maximise: {figure: GenPwr_mean, where: {wind.speed_mps: 15}}\n")
                .find("not in the range"),
            std::string::npos);
  EXPECT_NE(refusal(grid + objective + "conditions: [{figure: GenPwr_mean}]\n")
                .find("either at_least_percent or at_most_percent"),
            std::string::npos);
  EXPECT_NE(
      refusal("parameters: {RatedTorque: {a: {b: 1}}}\n" + objective).find("expected numbers"),
      std::string::npos);
  EXPECT_NE(refusal(grid + objective + "refinement: 4\n").find("did you mean 'refinements'"),
            std::string::npos);
  EXPECT_NE(error_text([&] {
              tuning(grid + objective);
              std::string text = folder_.read("tuning.yaml");
              text.replace(text.find("controller: after"), 17, "controller: aftr");
              load_tuning(folder_.write("tuning.yaml", text));
            }).find("did you mean 'after'"),
            std::string::npos);
}

// All combinations, the last parameter fastest.
TEST(GridPoints, LastFastest) {
  EXPECT_EQ(grid_points({{"a", {1, 2}}, {"b", {3, 4}}}),
            (std::vector<Point>{{1, 3}, {1, 4}, {2, 3}, {2, 4}}));
}

// The tuning of Schlipf et al. (2020) that is shipped can be flown.
TEST(ShippedTunings, S20) {
  const Tuning t = load_tuning(LAC_SOURCE_DIR "/config/tuning/s20.yaml");
  EXPECT_EQ(t.cases.size(), 12U);
  EXPECT_EQ(t.targets.front().cases.size(), 6U);
}

}  // namespace
}  // namespace lac::sim
