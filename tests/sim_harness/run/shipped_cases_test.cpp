// SPDX-License-Identifier: Apache-2.0
// The cases in config/, flown by the libraries of this build.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

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

}  // namespace
}  // namespace lac::sim
