// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_clock.hpp"

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

LidarMeasurement at(double time_s) {
  LidarMeasurement m;
  m.time_s = time_s;
  m.gate_count = 1;
  m.gates[0].speed_mps = 2.0 * time_s;
  return m;
}

// stamp = t + offset + drift t; 100 s at 200 ppm are 20 ms.
TEST(LidarClock, Stamp) {
  LidarClock clock({.offset_s = -0.5, .drift_ppm = 200.0});
  LidarMeasurement m = at(100.0);
  EXPECT_TRUE(clock.pass(m, true));
  EXPECT_NEAR(m.time_s, 99.52, 1e-12);
  EXPECT_FALSE(clock.pass(m, false));
  EXPECT_NEAR(m.time_s, 99.52, 1e-12);
}

// Each measurement comes 3 steps later, none is lost, whether they come in every step or at odd
// intervals shorter and longer than the latency.
TEST(LidarClock, Latency) {
  LidarClock clock({.latency_steps = 3});
  const std::vector<bool> has_new{true, true, false, false, false, true,  true, true,
                                  true, true, false, true,  false, false, false};
  LidarMeasurement m;
  for (std::size_t n = 0; n < has_new.size(); ++n) {
    if (has_new[n]) m = at(static_cast<double>(n));
    const bool is_new = clock.pass(m, has_new[n]);
    ASSERT_EQ(is_new, n >= 3 && has_new[n - 3]) << n;
    if (!is_new) continue;
    EXPECT_EQ(m.time_s, static_cast<double>(n - 3));
    EXPECT_EQ(m.gates[0].speed_mps, 2.0 * static_cast<double>(n - 3));
  }
}

TEST(LidarClock, Keys) {
  const test::TempFolder folder;
  YamlReader in =
      YamlReader::load(folder.write("a.yaml", "{offset_s: 0.2, drift_ppm: 50, latency_steps: 8}"));
  const LidarClockParams p = read_lidar_clock(in);
  in.finish();
  EXPECT_TRUE(p.enabled());
  EXPECT_EQ(p.offset_s, 0.2);
  EXPECT_EQ(p.drift_ppm, 50.0);
  EXPECT_EQ(p.latency_steps, 8);
  EXPECT_FALSE(LidarClockParams{}.enabled());
}

}  // namespace
}  // namespace lac::sim
