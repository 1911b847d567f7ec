// SPDX-License-Identifier: Apache-2.0
#include "bridge/bridge_params.hpp"

#include <gmock/gmock.h>

#include <regex>

#include "core/units.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using testing::HasSubstr;

const std::string kAdded =
    "added ! FeedforwardRoute\n30 ! LeakTime\n5 ! Authority\n"
    "0 ! MinimumPitch\n90 ! MaximumPitch\n8 ! MaximumPitchRate\n";

BridgeParams read(const std::string& text) {
  InputFile in = InputFile::parse(text, "bridge.IN");
  return BridgeParams::read(in);
}
std::string error_of(const std::string& text) {
  return test::error_text([&] { read(text); });
}

/// A shipped file, without the line that names an input file of ROSCO.
BridgeParams shipped(const std::string& name) {
  const test::TempFolder folder;
  std::filesystem::copy_file(LAC_SOURCE_DIR "/config/rosco/" + name, folder.path() / name);
  return read(std::regex_replace(folder.read(name), std::regex("[^\n]*! RoscoInput[^\n]*"), ""));
}

// The shipped files; degrees inside are radians.
TEST(BridgeParams, ShippedFiles) {
  const BridgeParams tower = shipped("bridge_tower_damper.IN");
  EXPECT_EQ(tower.feedforward, FeedforwardRoute::TowerDamper);
  EXPECT_EQ(tower.tower_damper_gain, 0.01);
  const BridgeParams added = shipped("bridge_added.IN");
  EXPECT_EQ(added.feedforward, FeedforwardRoute::Added);
  EXPECT_NEAR(added.increment.authority_rad, rad_from_deg(5.0), 1e-15);
  EXPECT_NEAR(added.limits.max_rate_radps, rad_from_deg(10.0), 1e-15);
  EXPECT_EQ(shipped("bridge_derating.IN").derating, DeratingRoute::HubWind);
}

// One key changes the route: the keys of the other may stay.
TEST(BridgeParams, KeysOfAnotherRouteMayStay) {
  const std::string none = "none" + kAdded.substr(5) + "0.01 ! TowerDamperGain\n";
  EXPECT_EQ(read(none).feedforward, FeedforwardRoute::None);
  EXPECT_EQ(read("none ! FeedforwardRoute\n").derating, DeratingRoute::None);
}

// Each mistake is named with file, line, key, what was found and expected.
TEST(BridgeParams, Mistakes) {
  EXPECT_THAT(
      error_of("tower ! FeedforwardRoute\n"),
      HasSubstr("bridge.IN:1: FeedforwardRoute: found 'tower', expected one of none, tower_dam"));
  EXPECT_THAT(error_of("tower_damper ! FeedforwardRoute\n5 ! Authority\n"),
              HasSubstr("TowerDamperGain: missing"));
  EXPECT_THAT(error_of("added ! FeedforwardRoute\n5 ! Authority\n"),
              HasSubstr("MinimumPitch: missing"));
  EXPECT_THAT(error_of(std::regex_replace(kAdded, std::regex("30 "), "0 ")),
              HasSubstr("bridge.IN:2: LeakTime: found 0, expected more with FeedforwardRoute"));
  EXPECT_THAT(error_of(std::regex_replace(kAdded, std::regex("90 "), "0 ")),
              HasSubstr("bridge.IN:5: MaximumPitch: found 0, expected more than MinimumPitch, 0"));
  EXPECT_THAT(error_of(kAdded + "1 ! LeakTim\n"), HasSubstr("did you mean 'LeakTime'"));
  InputFile in = InputFile::parse(kAdded + "0.01 ! FadeTime\n", "bridge.IN");
  const BridgeParams p = BridgeParams::read(in);
  EXPECT_THAT(test::error_text([&] { p.check_time_step(in, 0.0125); }),
              HasSubstr("bridge.IN:7: FadeTime: found 0.01 s, expected at least one step"));
}

}  // namespace
}  // namespace lac
