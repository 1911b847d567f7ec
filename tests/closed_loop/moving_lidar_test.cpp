// SPDX-License-Identifier: Apache-2.0
// A lidar that is carried about, and what the chain makes of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "closed_loop/case_flight.hpp"

namespace lac::test {
namespace {

constexpr char kRoughSea[] =
    "lidar.platform={surge: {amplitude: [2], period_s: [12]}, heave: {amplitude: [1], period_s: "
    "[9]}, "
    "roll: {amplitude: [3], period_s: [15]}, pitch: {mean: 3, amplitude: [4], period_s: [25]}, "
    "yaw: {amplitude: [5], period_s: [70]}}";

CaseFlight demo_in_steady_wind(const std::string& platform) {
  std::vector<std::string> overrides{"wind={kind: steady, speed_mps: 18}", "time.duration_s=60",
                                     "time.run_in_s=20"};
  if (!platform.empty()) overrides.push_back(platform);
  return CaseFlight("demo.yaml", overrides);
}

// Steady wind of 18 m/s seen from a platform that surges, heaves, rolls, pitches and yaws (line-of-
// sight speeds swing by 2 m/s): the chain takes the motion out with the lidar's own attitude and
// velocity, and the pitch demand stays as with a lidar at rest, within 0.002 deg.
TEST(MovingLidar, MotionIsTakenOut) {
  const CaseFlight at_rest = demo_in_steady_wind("");
  const CaseFlight afloat = demo_in_steady_wind(kRoughSea);
  const auto still = at_rest.fly(1).recording.column("BldPitchDem");
  const auto moved = afloat.fly(1).recording.column("BldPitchDem");
  ASSERT_EQ(still.size(), moved.size());
  for (std::size_t n = 0; n < still.size(); ++n) ASSERT_NEAR(moved[n], still[n], 0.002) << n;
}

/// The chain of the demo with MotionCompensation off, in a copy of its folders.
sim::CaseController without_compensation(const CaseFlight& flight, const TempFolder& copy) {
  namespace fs = std::filesystem;
  for (const char* folder : {"nrel5mw", "turbines"}) {
    fs::copy(fs::path(LAC_SOURCE_DIR "/config") / folder, copy.path(folder),
             fs::copy_options::recursive);
  }
  std::string text = copy.read("nrel5mw/ldp.IN");
  text.replace(text.rfind("true", text.find("! MotionCompensation")), 4, "false");
  copy.write("nrel5mw/ldp.IN", text);
  sim::CaseController controller = flight.c.controllers.at(1);
  controller.input_file = copy.path("nrel5mw") / controller.input_file.filename();
  return controller;
}

// The same with the compensation switched off: the pitch demand swings by degrees, so the test
// above has something to take out.
TEST(MovingLidar, MotionWouldBeSeen) {
  const CaseFlight afloat = demo_in_steady_wind(kRoughSea);
  const TempFolder folder;
  const auto pitch_deg =
      afloat.fly(without_compensation(afloat, folder)).recording.column("BldPitchDem");
  const auto [least, most] = std::minmax_element(pitch_deg.begin() + 1600, pitch_deg.end());
  EXPECT_GT(*most - *least, 0.5);
}

}  // namespace
}  // namespace lac::test
