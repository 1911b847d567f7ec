// SPDX-License-Identifier: Apache-2.0
// The built library through its C entry, as the master calls it.
#include <gtest/gtest.h>

#include "support/discon_caller.hpp"
#include "support/lidar_scan.hpp"

namespace lac {
namespace {

using test::DisconCaller;

std::string shipped() {
  return LAC_SOURCE_DIR "/config/nrel5mw/ldp.IN";
}

// The shipped input file runs, and a scan of steady wind arrives in the chain records.
TEST(LdpLibrary, ScanToChainRecords) {
  DisconCaller caller("liblac_ldp", shipped());
  test::LidarScan scan;
  for (int i = 0; i < 1600; ++i) {
    const double t = i * caller.time_step_s;
    write_native_lidar(caller.swap(), scan.measure(t, i / 20 % 4), i % 20 == 0);
    ASSERT_EQ(caller.call(i == 0 ? 0 : 1), 0) << caller.message();
  }
  EXPECT_NEAR(caller.swap().get(Rec::LidarRews), 16.0, 1e-5);
  EXPECT_EQ(caller.swap().get(Rec::LidarRewsValid), 1.0);
  EXPECT_NEAR(caller.swap().get(Rec::LidarMeanSpeed), 16.0, 1e-5);
  EXPECT_EQ(caller.call(-1), 0);
}

// A dead lidar is told once, not at every step.
TEST(LdpLibrary, DeadLidarIsToldOnce) {
  DisconCaller caller("liblac_ldp", shipped());
  test::LidarScan scan;
  int messages = 0;
  for (int i = 0; i < 4000; ++i) {
    const double t = i * caller.time_step_s;
    write_native_lidar(caller.swap(), scan.measure(t, i / 20 % 4), i % 20 == 0 && i < 1600);
    messages += caller.call(i == 0 ? 0 : 1) > 0 ? 1 : 0;
  }
  EXPECT_EQ(messages, 1);
  EXPECT_EQ(caller.swap().get(Rec::LidarRewsValid), 0.0);
}

// So is one that never says anything that can be used.
TEST(LdpLibrary, SilenceFromTheStartIsToldOnce) {
  DisconCaller caller("liblac_ldp", shipped());
  test::LidarScan scan;
  int messages = 0;
  for (int i = 0; i < 8000; ++i) {
    LidarMeasurement sent = scan.measure(i * caller.time_step_s, i / 20 % 4);
    for (LidarGate& gate : sent.gates) gate.valid = false;
    write_native_lidar(caller.swap(), sent, i % 20 == 0);
    if (caller.call(i == 0 ? 0 : 1) == 0) continue;
    ++messages;
    EXPECT_NE(caller.message().find("no valid lidar wind speed since the start, 60 s"),
              std::string::npos)
        << caller.message();
  }
  EXPECT_EQ(messages, 1);
}

// A lidar that scans more slowly than the input file says is told once.
TEST(LdpLibrary, SlowerScanThanToldIsTold) {
  DisconCaller caller("liblac_ldp", shipped());
  test::LidarScan scan;
  int messages = 0;
  for (int i = 0; i < 4000; ++i) {
    write_native_lidar(caller.swap(), scan.measure(i * caller.time_step_s, i / 40 % 4),
                       i % 40 == 0);
    if (caller.call(i == 0 ? 0 : 1) > 0) {
      ++messages;
      EXPECT_NE(caller.message().find("after 2 s, ScanTime says 1 s"), std::string::npos);
    }
  }
  EXPECT_EQ(messages, 1);
}

// A host that fills no lidar block gets a warning that says so, and the run goes on.
TEST(LdpLibrary, NoLidarBlockIsAWarning) {
  DisconCaller caller("liblac_ldp", shipped());
  EXPECT_EQ(caller.call(0), 1);
  EXPECT_NE(caller.message().find("fills no native lidar block"), std::string::npos);
  EXPECT_EQ(caller.call(1), 0);
}

// Called by a host directly there is no chain to write to: refused with what to do.
TEST(LdpLibrary, WithoutTheChainBlockItSaysWhatToDo) {
  DisconCaller caller("liblac_ldp", shipped(), kExtendedArraySize);
  EXPECT_EQ(caller.call(0), -1);
  EXPECT_NE(caller.message().find("works behind the LAC wrapper"), std::string::npos);
}

}  // namespace
}  // namespace lac
