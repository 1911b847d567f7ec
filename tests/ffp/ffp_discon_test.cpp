// SPDX-License-Identifier: Apache-2.0
// The built library through its C entry, as the master calls it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "support/discon_caller.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using test::DisconCaller;

std::string shipped() {
  return LAC_SOURCE_DIR "/config/nrel5mw/ffp.IN";
}

/// The shipped file with one more line, in a folder of its own.
std::string with_line(const test::TempFolder& folder, const std::string& line) {
  std::ifstream in(shipped());
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return folder.write("ffp.IN", text + "\n" + line + "\n");
}

void give_wind(SwapView swap, double rews_mps) {
  swap.set(Rec::LidarRews, rews_mps);
  swap.set(Rec::LidarRewsValid, 1.0);
  swap.set(Rec::LidarRewsLead, 4.5);
  swap.set(Rec::LidarScanWindow, 1.0);
  swap.set(Rec::LidarMeanSpeed, 18.0);
}

// The shipped input file runs: a ramp of wind gives the slope of its pitch curve.
TEST(FfpLibrary, RampGivesThePitchRate) {
  DisconCaller caller("liblac_ffp", shipped());
  for (int i = 0; i < 4800; ++i) {
    give_wind(caller.swap(), 17.2 + 0.01 * i * caller.time_step_s);
    ASSERT_EQ(caller.call(i == 0 ? 0 : 1), 0) << caller.message();
  }
  EXPECT_EQ(caller.swap().get(Rec::FeedforwardActive), 1.0);
  const double slope_radps = (14.919 - 13.542) * 0.01 * 3.14159265 / 180.0;
  EXPECT_NEAR(caller.swap().get(Rec::FeedforwardPitchRate), slope_radps, 0.01 * slope_radps);
}

// Wind that was there and is lost is told once, with the reason in the record.
TEST(FfpLibrary, LosingTheWindIsToldOnce) {
  DisconCaller caller("liblac_ffp", shipped());
  int messages = 0;
  for (int i = 0; i < 3000; ++i) {
    give_wind(caller.swap(), 18.0);
    if (i > 2000) caller.swap().set(Rec::LidarRewsValid, 0.0);
    messages += caller.call(i == 0 ? 0 : 1) > 0 ? 1 : 0;
  }
  EXPECT_EQ(messages, 1);
  EXPECT_NE(caller.swap().get(Rec::FeedforwardReason), 0.0);
  EXPECT_EQ(caller.swap().get(Rec::FeedforwardPitchRate), 0.0);
}

// The shipped input with UseMonitor: authority and trim come from the monitor's records, a broken
// monitor is told once, and the share in use is written.
TEST(FfpLibrary, MonitorRecords) {
  const test::TempFolder folder;
  DisconCaller caller("liblac_ffp", with_line(folder, "true ! UseMonitor"));
  int messages = 0;
  const auto fly = [&](int from, int to, double authority, double trim_s) {
    for (int i = from; i < to; ++i) {
      give_wind(caller.swap(), 18.0);
      caller.swap().set(Rec::MonitorAuthority, authority);
      caller.swap().set(Rec::MonitorBufferTrim, trim_s);
      messages += caller.call(i == 0 ? 0 : 1) > 0 ? 1 : 0;
    }
  };
  fly(0, 1, 1.0, 0.0);
  const double untrimmed_s = caller.swap().get(Rec::FeedforwardLeadNeeded);
  fly(1, 3000, 0.25, -0.5);
  EXPECT_EQ(caller.swap().get(Rec::FeedforwardAuthority), 0.25);
  EXPECT_EQ(caller.swap().get(Rec::FeedforwardReason), 8.0);
  EXPECT_NEAR(caller.swap().get(Rec::FeedforwardLeadNeeded), untrimmed_s + 0.5, 1e-6);
  EXPECT_EQ(messages, 0);
  for (int i = 0; i < 3; ++i) {
    fly(1, 100, std::nan(""), 0.0);
    EXPECT_EQ(caller.swap().get(Rec::FeedforwardReason), 9.0);
    EXPECT_EQ(caller.swap().get(Rec::FeedforwardAuthority), 0.0);
    fly(1, 100, 1.0, 0.0);
    EXPECT_EQ(caller.swap().get(Rec::FeedforwardAuthority), 1.0);
  }
  EXPECT_EQ(messages, 1);
}

// UseMonitor in a chain without one: off, and told once.
TEST(FfpLibrary, MissingMonitorIsToldOnce) {
  const test::TempFolder folder;
  DisconCaller caller("liblac_ffp", with_line(folder, "true ! UseMonitor"));
  std::string told;
  for (int i = 0; i < 1000; ++i) {
    give_wind(caller.swap(), 18.0);
    if (caller.call(i == 0 ? 0 : 1) > 0) told += caller.message() + "\n";
  }
  EXPECT_EQ(told,
            "ffp: feedforward off: UseMonitor is set, but no monitor in the chain writes its "
            "share\n");
  EXPECT_EQ(caller.swap().get(Rec::FeedforwardAuthority), 0.0);
}

}  // namespace
}  // namespace lac
