// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_fault.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using testing::HasSubstr;

/// Measurement k of two beams, one a second, speeds 10 k + gate.
LidarMeasurement measurement(int k) {
  LidarMeasurement m;
  m.time_s = k;
  m.beam_id = k % 2;
  m.gate_count = 2;
  m.gates[0] = {50.0, 10.0 * k, true, 0.0};
  m.gates[1] = {80.0, 10.0 * k + 1.0, true, 0.0};
  return m;
}

/// What arrives at time k when the fault lasts from 10 to 20 s.
struct Arrival {
  bool is_new = false;
  LidarMeasurement m;
};
Arrival arrival_at(LidarFaultKind kind, int k) {
  LidarFaultInjector injector({kind, 10.0, 20.0}, 2);
  Arrival a;
  for (int i = 0; i <= k; ++i) {
    a.m = measurement(i);
    a.is_new = injector.apply(i, a.m, true);
  }
  return a;
}

// Before and after the fault, and without one, everything passes as it is.
TEST(LidarFaultTest, PassesOutsideOfTheFault) {
  for (const LidarFaultKind kind :
       {LidarFaultKind::kNone, LidarFaultKind::kDead, LidarFaultKind::kNotANumber,
        LidarFaultKind::kStuck, LidarFaultKind::kFrozen, LidarFaultKind::kOutOfRange}) {
    for (const int k : {9, 20}) {
      const Arrival a = arrival_at(kind, k);
      EXPECT_TRUE(a.is_new);
      EXPECT_EQ(a.m.gates[1].speed_mps, 10.0 * k + 1.0);
    }
  }
  EXPECT_EQ(arrival_at(LidarFaultKind::kNone, 15).m.gates[0].speed_mps, 150.0);
}

// No measurement at all.
TEST(LidarFaultTest, Dead) {
  EXPECT_FALSE(arrival_at(LidarFaultKind::kDead, 10).is_new);
  EXPECT_FALSE(arrival_at(LidarFaultKind::kDead, 19).is_new);
}

// Not a number, and 999, under a flag and a validity that claim the opposite.
TEST(LidarFaultTest, LyingValues) {
  const Arrival nan = arrival_at(LidarFaultKind::kNotANumber, 12);
  EXPECT_TRUE(nan.is_new && nan.m.gates[0].valid && std::isnan(nan.m.gates[0].speed_mps));
  const Arrival off = arrival_at(LidarFaultKind::kOutOfRange, 12);
  EXPECT_TRUE(off.is_new && off.m.gates[1].valid);
  EXPECT_EQ(off.m.gates[1].speed_mps, 999.0);
}

// Stuck: every beam repeats its own last speeds (beam 0: second 8, beam 1: second 9), time goes on.
TEST(LidarFaultTest, Stuck) {
  const Arrival even = arrival_at(LidarFaultKind::kStuck, 14);
  EXPECT_EQ(even.m.gates[0].speed_mps, 80.0);
  EXPECT_EQ(even.m.beam_id, 0);
  EXPECT_EQ(even.m.time_s, 14.0);
  EXPECT_EQ(arrival_at(LidarFaultKind::kStuck, 15).m.gates[0].speed_mps, 90.0);
}

// Frozen: the last message again and again, its time included.
TEST(LidarFaultTest, Frozen) {
  const Arrival a = arrival_at(LidarFaultKind::kFrozen, 14);
  EXPECT_TRUE(a.is_new);
  EXPECT_EQ(a.m.gates[0].speed_mps, 90.0);
  EXPECT_EQ(a.m.beam_id, 1);
  EXPECT_EQ(a.m.time_s, 9.0);
}

// Speeds come multiplied.
TEST(LidarFaultTest, Bias) {
  LidarFaultInjector injector({.kind = LidarFaultKind::kBias, .start_s = 10.0, .factor = 1.2}, 2);
  for (int k = 0; k < 20; ++k) {
    LidarMeasurement m = measurement(k);
    ASSERT_TRUE(injector.apply(k, m, true));
    EXPECT_DOUBLE_EQ(m.gates[1].speed_mps, (k < 10 ? 1.0 : 1.2) * (10.0 * k + 1.0));
  }
}

// One beam repeats what it measured last, the other goes on.
TEST(LidarFaultTest, StuckBeam) {
  LidarFaultInjector injector(
      {.kind = LidarFaultKind::kStuckBeam, .start_s = 10.0, .end_s = 20.0, .beam_id = 1}, 2);
  for (int k = 0; k < 24; ++k) {
    LidarMeasurement m = measurement(k);
    ASSERT_TRUE(injector.apply(k, m, true));
    const bool stuck = k % 2 == 1 && k >= 10 && k < 20;
    EXPECT_EQ(m.gates[0].speed_mps, stuck ? 90.0 : 10.0 * k) << k;
  }
}

// The share that is asked for is lost (four standard deviations of 20000 draws), the rest passes as
// it is; the same seed loses the same.
TEST(LidarFaultTest, Missing) {
  const LidarFault fault{.kind = LidarFaultKind::kMissing, .share = 0.3};
  LidarFaultInjector injector(fault, 2, 5), same(fault, 2, 5), other(fault, 2, 6);
  int lost = 0, different = 0;
  for (int k = 0; k < 20000; ++k) {
    LidarMeasurement m = measurement(k);
    const bool arrives = injector.apply(k, m, true);
    EXPECT_EQ(m.gates[0].speed_mps, 10.0 * k);
    EXPECT_FALSE(injector.apply(k, m, false));  // nothing new draws nothing
    lost += arrives ? 0 : 1;
    ASSERT_EQ(same.apply(k, m, true), arrives);
    different += other.apply(k, m, true) == arrives ? 0 : 1;
  }
  EXPECT_NEAR(lost, 6000, 4 * std::sqrt(20000 * 0.3 * 0.7));
  EXPECT_GT(different, 1000);
}

// Keys belong to their kind; a beam that the lidar does not have is refused.
TEST(LidarFaultTest, Keys) {
  const test::TempFolder folder;
  const auto read = [&](const std::string& text) {
    YamlReader in = YamlReader::load(folder.write("fault.yaml", text));
    const LidarFault fault = read_lidar_fault(in, 4);
    in.finish();
    return fault;
  };
  EXPECT_EQ(read("{kind: bias, factor: 0.8}").factor, 0.8);
  EXPECT_EQ(read("{kind: missing, share: 0.5}").share, 0.5);
  EXPECT_EQ(read("{kind: stuck_beam, beam: 4}").beam_id, 3);
  EXPECT_THAT(test::error_text([&] { read("{kind: stuck_beam, beam: 5}"); }), HasSubstr("beam"));
  EXPECT_THAT(test::error_text([&] { read("{kind: stuck, beam: 1}"); }), HasSubstr("beam"));
  EXPECT_THAT(test::error_text([&] { read("{kind: bias}"); }), HasSubstr("factor"));
  EXPECT_THAT(test::error_text([&] { read("{kind: missing, share: 1.5}"); }), HasSubstr("share"));
}

// A fault from the start of the run: stuck repeats the first measurement of each beam, frozen the
// first message.
TEST(LidarFaultTest, FromTheStart) {
  for (const LidarFaultKind kind : {LidarFaultKind::kStuck, LidarFaultKind::kFrozen}) {
    LidarFaultInjector injector({kind}, 2);
    for (int k = 0; k < 6; ++k) {
      LidarMeasurement m = measurement(k);
      ASSERT_TRUE(injector.apply(k, m, true));
      const bool stuck = kind == LidarFaultKind::kStuck;
      EXPECT_EQ(m.gates[0].speed_mps, stuck ? 10.0 * (k % 2) : 0.0);
      EXPECT_EQ(m.time_s, stuck ? k : 0);
      EXPECT_EQ(m.beam_id, stuck ? k % 2 : 0);
    }
  }
}

}  // namespace
}  // namespace lac::sim
