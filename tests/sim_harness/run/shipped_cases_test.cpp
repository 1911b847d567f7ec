// SPDX-License-Identifier: Apache-2.0
// The cases in config/, flown by the libraries of this build.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/input_file.hpp"
#include "sim_harness/run/run_case.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

constexpr double kRated_rpm = 12.1;

Case shipped(const std::string& name, const test::TempFolder& results,
             const std::vector<std::string>& overrides = {}) {
  Case c = load_case(LAC_SOURCE_DIR "/config/" + name, overrides);
  c.outputs.folder = results.path();
  return c;
}

// Every case file can be read, and its controllers' input files are there.
TEST(ShippedCasesTest, AllCanBeRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LAC_SOURCE_DIR "/config")) {
    if (entry.path().extension() != ".yaml") continue;
    const Case c = load_case(entry.path());
    for (const CaseController& controller : c.controllers) {
      EXPECT_TRUE(std::filesystem::is_regular_file(controller.input_file))
          << entry.path() << ": " << controller.input_file;
    }
    ++count;
  }
  EXPECT_GE(count, 4);
}

// Steady wind of 18 m/s: NREL's report has 12.1 rpm, 5000 kW and 14.92 deg.
TEST(ShippedCasesTest, SteadyState) {
  const test::TempFolder results;
  std::ostringstream out;
  const CaseResult r = run_case(shipped("steady.yaml", results), out);
  EXPECT_NEAR(r.figures[0].rotor_speed_max_rpm, kRated_rpm, 0.01 * kRated_rpm);
  EXPECT_NEAR(r.figures[0].power_mean_kW, 5000.0, 50.0);
  std::istringstream csv(results.read("feedback-only.csv"));
  std::string line, last;
  std::getline(csv, line);
  EXPECT_EQ(line.find("BldPitch1"), line.find("GenSpeed [rpm],") + 15);  // the fifth channel
  while (std::getline(csv, line)) last = line;
  std::istringstream values(last);
  for (int i = 0; i < 6; ++i) std::getline(values, line, ',');
  EXPECT_NEAR(std::stod(line), 14.92, 0.7);
}

// IEA 3.4 MW in steady wind of 14 m/s: rated speed and power of FBv1, and the pitch that the static
// curve of its feedforward has there.
TEST(ShippedCasesTest, SteadyStateOfIea3p4mw) {
  const test::TempFolder results;
  std::ostringstream out;
  const CaseResult r =
      run_case(shipped("steady.yaml", results,
                       {"turbine=turbines/iea3p4mw/turbine.yaml", "wind.speed_mps=14",
                        "controllers.0.input=iea3p4mw/wrapper_fb.IN"}),
               out);
  EXPECT_NEAR(r.figures[0].rotor_speed_max_rpm, 11.753, 1e-3);
  EXPECT_NEAR(r.figures[0].power_mean_kW, 3369.24, 0.1);
  InputFile ffp = InputFile::load(LAC_SOURCE_DIR "/config/iea3p4mw/ffp.IN");
  const std::vector<double> wind_mps = ffp.numbers("StaticWind");
  const auto at = std::ranges::find(wind_mps, 14.0);
  ASSERT_NE(at, wind_mps.end());
  const double curve_deg = ffp.numbers("StaticPitch").at(at - wind_mps.begin());
  EXPECT_NEAR(r.flights[0].recording.column("BldPitch1").back(), curve_deg, 0.01);
}

}  // namespace
}  // namespace lac::sim
