// SPDX-License-Identifier: Apache-2.0
// The built library through its C entry, as the master calls it.
#include <gtest/gtest.h>

#include <cmath>

#include "support/discon_caller.hpp"

namespace lac {
namespace {

using test::DisconCaller;

std::string shipped() {
  return LAC_SOURCE_DIR "/config/nrel5mw/ffp.IN";
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

}  // namespace
}  // namespace lac
