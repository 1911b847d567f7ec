// SPDX-License-Identifier: Apache-2.0
// The built library through its C entry, as the master calls it.
#include <gtest/gtest.h>

#include <cmath>

#include "ldp/wind_reconstruction.hpp"
#include "support/discon_caller.hpp"
#include "support/lidar_scan.hpp"
#include "support/temp_folder.hpp"

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

/// Flies a minute and more in steady wind; gives all messages.
std::string fly(DisconCaller& caller, const test::LidarScan& scan, int steps, int every = 1) {
  std::string told;
  for (int i = 0; i < steps; ++i) {
    const bool is_new = i % (20 * every) == 0;
    write_native_lidar(caller.swap(), scan.measure(i * caller.time_step_s, i / 20 % 4), is_new);
    if (caller.call(i == 0 ? 0 : 1) != 0) told += caller.message() + "\n";
  }
  return told;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// With everything asked for: straight wind, and the records say so. Without, they are not numbers.
TEST(LdpLibrary, WindModelToChainRecords) {
  DisconCaller caller("liblac_ldp", LAC_SOURCE_DIR "/config/nrel5mw/ldp_wind.IN");
  test::LidarScan scan;
  EXPECT_EQ(fly(caller, scan, 25000), "");
  SwapView swap = caller.swap();
  EXPECT_EQ(swap.get(Rec::LidarReconstruction), static_cast<int>(WindReason::Complete));
  EXPECT_NEAR(swap.get(Rec::LidarYawError), 0.0, 1e-5);
  EXPECT_NEAR(swap.get(Rec::LidarInflowAngle), 0.0, 1e-5);
  EXPECT_NEAR(swap.get(Rec::LidarHorizontalShear), 0.0, 1e-5);
  EXPECT_NEAR(swap.get(Rec::LidarVerticalShear), 0.0, 1e-5);
  EXPECT_EQ(swap.get(Rec::LidarAvailability), 1.0);
  EXPECT_GT(swap.get(Rec::LidarRews), 16.1);  // no rotor slowed it
  EXPECT_LT(swap.get(Rec::LidarRews), 16.4);

  DisconCaller plain("liblac_ldp", shipped());
  fly(plain, scan, 200);
  for (const Rec r : {Rec::LidarYawError, Rec::LidarHorizontalShear, Rec::LidarVerticalShear,
                      Rec::LidarInflowAngle}) {
    EXPECT_TRUE(std::isnan(plain.swap().get(r)));
  }
  EXPECT_EQ(plain.swap().get(Rec::LidarReconstruction), 0.0);
}

// What the beams cannot tell is told once; and so is a turbine that gives no wind speed.
TEST(LdpLibrary, RefusalIsToldOnce) {
  const test::TempFolder folder;
  const std::string file = folder.write(
      "ldp.IN",
      "4 ! NumberOfBeams\n1 ! ScanTime\nu_shear ! WindModel\n20 ! ReconstructionWindow\n"
      "90 ! HubHeight\n63 ! RotorRadius\nturbine ! TravelSpeed\n");
  DisconCaller caller("liblac_ldp", file);
  test::LidarScan level;
  level.elevation_rad = 0.0;
  const std::string told = fly(caller, level, 12000);
  EXPECT_EQ(count(told, "the beams cannot tell some quantities of WindModel"), 1U) << told;
  EXPECT_EQ(count(told, "no TurbineRews (3771)"), 1U) << told;
  EXPECT_EQ(caller.swap().get(Rec::LidarRewsValid), 0.0);
  EXPECT_EQ(caller.swap().get(Rec::LidarReconstruction), static_cast<int>(WindReason::Partly));
}

// The alarm of the availability comes once, after its time, and its end is told.
TEST(LdpLibrary, LowAvailabilityIsToldOnce) {
  const test::TempFolder folder;
  const std::string file =
      folder.write("ldp.IN",
                   "4 ! NumberOfBeams\n1 ! ScanTime\n1 ! MinimumSamples\n0.9 ! AvailabilityLimit\n"
                   "20 ! AvailabilityAlarmTime\n30 ! AvailabilityWindow\n");
  DisconCaller caller("liblac_ldp", file);
  test::LidarScan scan;
  const std::string told = fly(caller, scan, 8000, 2);  // every other measurement is missing
  EXPECT_EQ(count(told, "lidar availability is 50 %, below 90 % for 20 s"), 1U) << told;
  EXPECT_EQ(count(told, "availability"), 1U) << told;
  EXPECT_NEAR(caller.swap().get(Rec::LidarAvailability), 0.5, 0.02);
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
