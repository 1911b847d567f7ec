// SPDX-License-Identifier: Apache-2.0
#include "ldp/guo_ldp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "ldp/guo_ldp_discon.hpp"
#include "support/error_text.hpp"
#include "support/guo_host.hpp"
#include "support/no_alloc_guard.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using test::GuoHost;
using test::TempFolder;
using ::testing::HasSubstr;
using ::testing::StartsWith;

GuoLdpParams params(const std::string& text) {
  return GuoLdpParams::read(GuoInputFile::parse(text, "l.IN"));
}

double cosd(double deg) {
  return std::cos(deg * kPi / 180.0);
}

LidarMeasurement speeds(int beam, std::vector<double> values_mps) {
  LidarMeasurement m;
  m.beam_id = beam;
  m.gate_count = static_cast<int>(values_mps.size());
  for (std::size_t g = 0; g < values_mps.size(); ++g) m.gates[g].speed_mps = values_mps[g];
  return m;
}

/// One GuoLdp, measured once a second.
class Estimate {
 public:
  explicit Estimate(const std::string& text) : ldp_(params(text)), state_(ldp_.initial_state()) {}
  Ldp::Outputs measure(const LidarMeasurement& m) {
    return ldp_.step({&m, static_cast<double>(++seconds_)}, state_);
  }
  Ldp::Outputs measure(int beam, double los_mps) { return measure(speeds(beam, {los_mps})); }
  Ldp::Outputs wait(double s) { return ldp_.step({nullptr, seconds_ + s}, state_); }

 private:
  GuoLdp ldp_;
  GuoLdp::State state_;
  int seconds_ = 0;
};

// LDP_v1: u = v/(cos az cos el), the mean of the last four, valid after the first full scan.
TEST(GuoLdp, V1MeanOfTheLastScan) {
  Estimate e(test::kGuoLdpV1);
  const double x[4] = {cosd(16) * cosd(11), cosd(17) * cosd(13), cosd(15) * cosd(12),
                       cosd(18) * cosd(10.5)};
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(e.measure(i, 12.0 * x[i]).valid);
  EXPECT_NEAR(e.measure(3, 12.0 * x[3]).rews_mps, 12.0, 1e-12);
  const Ldp::Outputs out = e.measure(0, 20.0 * x[0]);
  EXPECT_TRUE(out.valid);
  EXPECT_EQ(out.samples, 4);
  EXPECT_NEAR(out.rews_mps, 14.0, 1e-12);  // (3 x 12 + 20)/4
  EXPECT_EQ(out.lead_s, 0.0);
  EXPECT_EQ(out.scan_time_s, 4.0);
}

// LDP_v2 takes attitude and velocity out of a tilted, moving lidar in a uniform wind along x.
TEST(GuoLdp, V2TakesTheMotionOut) {
  const double wind_mps = 13.0;
  LidarMeasurement m = speeds(1, {0.0});
  m.beam_dir_L = beam_direction(rad_from_deg(17), rad_from_deg(-13));
  m.roll_rad = 0.03, m.pitch_rad = -0.05, m.yaw_rad = kPi + 0.04;
  m.velocity_I_mps = {0.7, -0.3, 0.2};
  const Vec3 n = m.beam_dir_I();
  m.gates[0].speed_mps = -n.x * wind_mps + dot(n, m.velocity_I_mps);
  Estimate with(test::kGuoLdpV1 + "1 ! MC_Mode - [-]\n");
  EXPECT_NEAR(with.measure(m).rews_mps, wind_mps, 1e-12);
  Estimate without(test::kGuoLdpV1 + "0 ! MC_Mode - [-]\n");
  EXPECT_NEAR(without.measure(m).rews_mps, m.gates[0].speed_mps / (cosd(17) * cosd(13)), 1e-12);
}

// LDP_v3: each lidar has its own angle; theirs takes the first for all.
TEST(GuoLdp, V3EachLidarsOwnAngle) {
  Estimate ours(test::kGuoLdpV3), theirs(test::kGuoLdpV3 + test::kGuoLegacy);
  EXPECT_NEAR(ours.measure(1, 10.0 * cosd(35)).rews_mps, 10.0, 1e-12);
  EXPECT_NEAR(theirs.measure(1, 10.0 * cosd(35)).rews_mps, 10.0 * cosd(35) / cosd(20), 1e-12);
  for (int i = 0; i < 5; ++i) ours.measure(0, 13.0 * cosd(20));
  EXPECT_NEAR(ours.measure(0, 13.0 * cosd(20)).rews_mps, 13.0, 1e-12);  // six measurements
}

// v1.4 of Task 52: one angle for all beam ids, and the gate of IndexGate.
TEST(GuoLdp, Task52TakesItsGate) {
  Estimate e(test::kGuoLdpTask52);
  EXPECT_NEAR(e.measure(speeds(77, {3.0, 5.0, 11.0, 40.0})).rews_mps, 11.0 / cosd(19), 1e-12);
}

// Error values take their place in the mean, not part; more than half of them make it invalid.
TEST(GuoLdp, BadSamplesAreLeftOut) {
  Estimate e(test::kGuoLdpV1);
  const double x0 = cosd(16) * cosd(11);
  for (int i = 0; i < 4; ++i) e.measure(0, 12.0 * x0);
  Ldp::Outputs out;
  for (const double bad : {999.0, -99.4}) {
    out = e.measure(0, bad);
    EXPECT_NEAR(out.rews_mps, 12.0, 1e-12);
    EXPECT_TRUE(out.valid);
  }
  EXPECT_EQ(out.samples, 2);
  out = e.measure(0, std::nan(""));
  EXPECT_NEAR(out.rews_mps, 12.0, 1e-12);
  EXPECT_FALSE(out.valid);
  out = e.measure(0, 75.0);  // no wind speed
  EXPECT_TRUE(std::isnan(out.rews_mps));
  EXPECT_FALSE(out.valid);
}

// A lidar that says nothing more makes the estimate invalid after two scans.
TEST(GuoLdp, OldSamplesAreNoEstimate) {
  Estimate e(test::kGuoLdpV1);
  for (int i = 0; i < 6; ++i) e.measure(i % 4, 12.0);
  EXPECT_TRUE(e.wait(7.9).valid);
  EXPECT_FALSE(e.wait(8.1).valid);
}

// LegacyTiming as theirs: 0 at the start, -99 in the mean, 999 only left out undivided.
TEST(GuoLdp, LegacyIsAsTheirs) {
  Estimate e(test::kGuoHeader + "1 ! NumberOfBeams\n0 ! Lidar_Azimuth\n0 ! Lidar_Elevation\n" +
             test::kGuoLegacy);
  EXPECT_EQ(e.wait(0.0).rews_mps, 0.0);
  EXPECT_EQ(e.measure(0, -99.0).rews_mps, -99.0);
  EXPECT_EQ(e.measure(0, 999.0).rews_mps, 999.0);
  EXPECT_FALSE(e.wait(0.0).valid);
}

// A checkpoint holds the whole state: the estimate goes on to the last bit.
TEST(GuoLdp, StateIsComplete) {
  const GuoLdp ldp(params(test::kGuoLdpV1));
  GuoLdp::State a = ldp.initial_state(), b = ldp.initial_state();
  const auto step = [&](int i, GuoLdp::State& s) {
    const LidarMeasurement m = speeds(i % 4, {12.0 + std::sin(0.3 * i)});
    return ldp.step({i % 3 == 0 ? &m : nullptr, 0.1 * i}, s);
  };
  for (int i = 0; i < 50; ++i) step(i, a);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  a.visit(save);
  StateArchive load{std::span<const std::byte>(bytes)};
  b.visit(load);
  ASSERT_TRUE(load.complete());
  for (int i = 50; i < 90; ++i) {
    const Ldp::Outputs x = step(i, a), y = step(i, b);
    EXPECT_EQ(x.rews_mps, y.rews_mps);
    EXPECT_EQ(x.valid, y.valid);
    EXPECT_EQ(x.data_age_s, y.data_age_s);
    EXPECT_EQ(x.scan_time_s, y.scan_time_s);
    EXPECT_EQ(x.mean_speed_mps, y.mean_speed_mps);
  }
}

// Errors of values come with file, line and key of their form.
TEST(GuoLdpParams, Errors) {
  const auto error = [](const std::string& text) {
    return test::error_text([&] { params(test::kGuoHeader + text); });
  };
  EXPECT_EQ(error("2 ! NumberOfBeams\n1 2 3 ! Lidar_Azimuth\n1 2 ! Lidar_Elevation\n"),
            "l.IN:5: Lidar_Azimuth: found 3 values, expected 2 as NumberOfBeams says");
  EXPECT_EQ(error("1 ! NumberOfBeams\n90 ! Lidar_Azimuth\n2 ! Lidar_Elevation\n"),
            "l.IN:5: Lidar_Azimuth: found 90, expected a number from -87 to 87");
  EXPECT_EQ(error("1 ! NumberOfBeams\n0 ! AngleToCenterline\n0 ! IndexGate\n"),
            "l.IN:6: IndexGate: found 0, expected a number from 1 to 50");
  EXPECT_EQ(error("1 ! NumberOfBeams\n0 ! Lidar_Azimuth\n2 ! Lidar_Elevation\n2 ! MC_Mode\n"),
            "l.IN:7: MC_Mode: found '2', expected true or false");
  EXPECT_THAT(error("1 ! NumberOfBeams\n0 ! Lidar_Azimuth\n2 ! Lidar_Elevation\n\n1 ! MC_Mode\n"),
              StartsWith("l.IN:7: found '', expected 'value(s) ! MC_Mode', which stands in line 8; "
                         "read as LDP_v2"));
}

// In a foreign master: an array of unknown length, nothing written but the REWS; one note.
TEST(GuoLdpLibrary, ForeignMaster) {
  const TempFolder folder;
  GuoHost host("liblac_ldp", folder.write("l.IN", test::kGuoLdpV1));
  EXPECT_EQ(host.call(), 1);
  EXPECT_EQ(host.caller.message(),
            "ldp: input file read as LDP_v1 of Guo's chain; differences: docs/hosts/guo.md");
  EXPECT_EQ(host.result(guo_lidar::kRews), 999.0);  // none yet
  for (int i = 0; i < 4; ++i) {
    host.measure(i, {14.0 * (i % 2 == 0 ? 0.9 : 1.0)});
    const std::vector<float> before(host.caller.swap().data(), host.caller.swap().data() + 464);
    EXPECT_EQ(host.call(), 0) << host.caller.message();
    for (int r = 4; r <= 464; ++r) {  // records 1 to 3 are the caller's
      const bool own = r == GuoHost::kFirst + 10 || r == GuoHost::kFirst;
      if (own) continue;
      EXPECT_EQ(host.caller.swap().at(r), before[static_cast<std::size_t>(r - 1)]) << r;
    }
  }
  const double expected = 14.0 *
                          (0.9 / (cosd(16) * cosd(11)) + 1.0 / (cosd(17) * cosd(13)) +
                           0.9 / (cosd(15) * cosd(12)) + 1.0 / (cosd(18) * cosd(10.5))) /
                          4.0;
  EXPECT_NEAR(host.result(guo_lidar::kRews), expected, 1e-6);
  EXPECT_EQ(host.caller.call(-1), 0);
}

// Behind our master it also fills the records of the chain.
TEST(GuoLdpLibrary, BehindOurMaster) {
  const TempFolder folder;
  GuoHost host("liblac_ldp", folder.write("l.IN", test::kGuoLdpTask52), 3, kPrivateArraySize);
  host.call();
  const SwapReader swap = host.caller.swap();
  EXPECT_TRUE(std::isnan(swap.get(Rec::LidarRews)));
  EXPECT_EQ(swap.get(Rec::LidarRewsValid), 0.0);
  for (int i = 0; i < 8; ++i) {
    host.measure(i % 4, {0.0, 0.0, 15.0});
    for (int k = 0; k < 20; ++k) EXPECT_EQ(host.call(), 0) << host.caller.message();
  }
  const double u_mps = 15.0 / cosd(19);
  EXPECT_NEAR(swap.get(Rec::LidarRews), u_mps, 1e-6);
  EXPECT_NEAR(host.result(guo_lidar::kRews), u_mps, 1e-6);
  EXPECT_EQ(swap.get(Rec::LidarRewsValid), 1.0);
  EXPECT_EQ(swap.get(Rec::LidarRewsSamples), 4.0);
  EXPECT_EQ(swap.get(Rec::LidarRewsLead), 0.0);
  EXPECT_NEAR(swap.get(Rec::LidarScanWindow), 1.0, 1e-6);  // 4 x 20 x 0.0125 s
  EXPECT_NEAR(swap.get(Rec::LidarDataAge), 19 * 0.0125, 1e-6);
  EXPECT_NEAR(swap.get(Rec::LidarMeanSpeed), u_mps, 1e-6);
}

// No block, a block that reaches beyond a known array, no gate: told once, and nothing touched.
TEST(GuoLdpLibrary, NoBlockIsToldOnce) {
  const TempFolder folder;
  const std::string file = folder.write("l.IN", test::kGuoLdpV1);
  constexpr int kTooFar = kPrivateArraySize - 12;
  for (const double start : {0.0, 100.0, double{kTooFar}, 1.0e9}) {
    GuoHost host("liblac_ldp", file, 7, kPrivateArraySize);
    host.caller.swap().set(Rec::LogStart, start);
    if (start == kTooFar) host.caller.swap().put(kTooFar + 2, 7.0);
    EXPECT_EQ(host.caller.call(0), 1);
    EXPECT_THAT(host.caller.message(), HasSubstr("is not the start of a lidar block of Guo's"));
    EXPECT_EQ(host.caller.call(1), 0);
    EXPECT_EQ(host.caller.swap().get(Rec::LidarRewsValid), 0.0);
  }
}

// A beam without a direction, or a gate that is not there, is told once and not used.
TEST(GuoLdpLibrary, WrongBeamOrGateIsToldOnce) {
  const TempFolder folder;
  GuoHost v1("liblac_ldp", folder.write("v1.IN", test::kGuoLdpV1));
  v1.call();
  v1.measure(4, {10.0});
  EXPECT_EQ(v1.call(), 1);
  EXPECT_THAT(v1.caller.message(),
              HasSubstr("beam id 4, the input file has directions for 0 to 3"));
  v1.measure(-1, {10.0});
  EXPECT_EQ(v1.call(), 0);
  EXPECT_EQ(v1.result(guo_lidar::kRews), 999.0);
  GuoHost gates("liblac_ldp", folder.write("t.IN", test::kGuoLdpTask52), 2);
  gates.call();
  gates.measure(0, {10.0, 10.0});
  EXPECT_EQ(gates.call(), 1);
  EXPECT_THAT(gates.caller.message(), HasSubstr("2 gates, IndexGate is 3"));
}

// A file of both forms is refused with both names; LegacyTiming says so at the start.
TEST(GuoLdpLibrary, Start) {
  const TempFolder folder;
  GuoHost both("liblac_ldp", folder.write("b.IN", test::kGuoLdpV1 + "1.0 ! ScanTime\n"));
  EXPECT_EQ(both.call(), -1);
  EXPECT_THAT(both.caller.message(),
              HasSubstr("Guo's LDP files, ScanTime (line 7) in those of our"));
  GuoHost legacy("liblac_ldp", folder.write("g.IN", test::kGuoLdpV3 + test::kGuoLegacy));
  EXPECT_EQ(legacy.call(), 1);
  EXPECT_THAT(legacy.caller.message(), HasSubstr("LDP_v3 of Guo's chain, with LegacyTiming"));
  EXPECT_EQ(legacy.result(guo_lidar::kRews), 0.0);
}

// A step allocates nothing.
TEST(GuoLdpLibrary, StepsDoNotAllocate) {
  const TempFolder folder;
  GuoHost host("liblac_ldp", folder.write("l.IN", test::kGuoLdpV1));
  host.call();
  const std::vector<double> speed{13.0};
  const test::NoAllocGuard guard;
  for (int i = 0; i < 200; ++i) {
    host.measure(i % 4, speed);
    host.call();
  }
  EXPECT_EQ(guard.allocations(), 0U);
}

}  // namespace
}  // namespace lac
