// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/hard_target.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

/// Share of a range weighting that lies before an object, by quadrature of its shape.
double share_before(const RangeWeighting& w, double off_m) {
  constexpr double kStep_m = 0.01;
  double before = 0.0, all = 0.0;
  for (double s = -200.0 + 0.5 * kStep_m; s < 200.0; s += kStep_m) {
    all += w.shape(s);
    if (s < off_m) before += w.shape(s);
  }
  return before / all;
}

// Both pulsed shapes: the range weighting at the object, 1 in the centre, and what lies before it.
TEST(HardTarget, PulsedGate) {
  for (const ProbeKind kind : {ProbeKind::kGaussian, ProbeKind::kPulse}) {
    const RangeWeighting w{
        .kind = kind, .fwhm_m = 30.0, .pulse_length_m = 25.0, .gate_length_m = 20.0};
    for (const double off_m : {-25.0, -15.0, 0.0, 8.0, 30.0}) {
      const GateView v = gate_view(w, 100.0, 100.0 + off_m);
      EXPECT_NEAR(v.echo, w.shape(off_m) / w.shape(0.0), 1e-12);
      EXPECT_NEAR(v.before, share_before(w, off_m), 1e-6);
    }
  }
  EXPECT_NEAR(gate_view({.fwhm_m = 30.0}, 100.0, 115.0).echo, 0.5, 1e-12);  // half the width
}

// A focus at 150 m with a Rayleigh length of 10 m at 100 m: 22.5 m off it, half the echo and a
// quarter of the weight behind. A point: within half a metre.
TEST(HardTarget, FocusAndPoint) {
  const RangeWeighting w{
      .kind = ProbeKind::kLorentzian, .rayleigh_length_m = 10.0, .rayleigh_at_m = 100.0};
  const GateView v = gate_view(w, 150.0, 172.5);
  EXPECT_NEAR(v.echo, 0.5, 1e-12);
  EXPECT_NEAR(v.before, 0.75, 1e-12);
  EXPECT_EQ(gate_view({.fwhm_m = 0.0}, 100.0, 100.4).echo, 1.0);
  EXPECT_EQ(gate_view({.fwhm_m = 0.0}, 100.0, 100.6).echo, 0.0);
}

LidarGate air(double cnr_db = 0.0) {
  return {100.0, 12.0, true, cnr_db};
}

// A strong echo in the centre: the lidar reads its own motion, with the object's CNR.
TEST(HardTarget, StrongEcho) {
  HardTarget t;
  t.cnr_db = 60.0;
  LidarGate g = air();
  mix_in(t, {1.0, 0.5}, 0.3, g);
  EXPECT_NEAR(g.speed_mps, 0.3, 1e-5);
  EXPECT_NEAR(g.cnr_db, 60.0, 1e-5);
}

// 3 dB above air at half weight: 2 * 0.5 parts of the object and one of air (0.5 if opaque, as half
// of the gate lies behind); far from the object nothing changes.
TEST(HardTarget, MixesByPower) {
  HardTarget t;
  t.cnr_db = 10.0 * std::log10(2.0) - 6.0;
  t.opaque = false;
  LidarGate g = air(-6.0);
  mix_in(t, {0.5, 0.5}, 0.0, g);
  EXPECT_NEAR(g.speed_mps, 6.0, 1e-9);
  EXPECT_NEAR(g.cnr_db, -6.0 + 10.0 * std::log10(2.0), 1e-9);
  t.opaque = true;
  g = air(-6.0);
  mix_in(t, {0.5, 0.5}, 0.0, g);
  EXPECT_NEAR(g.speed_mps, 4.0, 1e-9);
  g = air(-6.0);
  mix_in(t, {0.0, 1.0}, 0.0, g);
  EXPECT_EQ(g.speed_mps, 12.0);
  EXPECT_NEAR(g.cnr_db, -6.0, 1e-9);
}

// Behind an opaque object there is no air and hardly an echo; the CNR is finite and low.
TEST(HardTarget, NothingBehind) {
  HardTarget t;
  LidarGate g = air();
  mix_in(t, gate_view({}, 300.0, 100.0), 0.0, g);
  EXPECT_LT(g.cnr_db, -90.0);
  EXPECT_TRUE(std::isfinite(g.cnr_db) && std::isfinite(g.speed_mps));
}

// Which beams meet it: window of directions in frame I seen up-wind, left positive; beam; time.
TEST(HardTarget, MetBy) {
  LidarMeasurement m;
  m.time_s = 50.0;
  m.beam_id = 2;
  m.beam_dir_L = beam_direction(0.2, -0.1);
  HardTarget t;
  EXPECT_TRUE(t.met_by(m));
  t.azimuth_min_rad = 0.19;
  t.azimuth_max_rad = 0.21;
  t.elevation_min_rad = -0.11;
  t.elevation_max_rad = -0.09;
  EXPECT_TRUE(t.met_by(m));
  m.roll_rad = 0.5 * kPi;
  EXPECT_FALSE(t.met_by(m));
  m.roll_rad = 0.0;
  t.beam = 1;
  EXPECT_FALSE(t.met_by(m));
  t.beam = 2;
  t.start_s = 50.0;
  t.end_s = 60.0;
  EXPECT_TRUE(t.met_by(m));
  m.time_s = 60.0;
  EXPECT_FALSE(t.met_by(m));
}

TEST(HardTarget, Keys) {
  const test::TempFolder folder;
  const auto read = [&](const std::string& text) {
    YamlReader in = YamlReader::load(folder.write("a.yaml", text));
    return read_hard_targets(in, "list");
  };
  const std::vector<HardTarget> t = read(
      "list:\n- distance_m: 80\n- {distance_m: 120, cnr_db: 5, opaque: no, beam: 2, azimuth_deg: "
      "[-10, 5], elevation_deg: [0, 90], start_s: 3, end_s: 4}\n");
  ASSERT_EQ(t.size(), 2U);
  EXPECT_EQ(t[0].beam, -1);
  EXPECT_TRUE(t[0].opaque);
  EXPECT_EQ(t[1].beam, 1);
  EXPECT_FALSE(t[1].opaque);
  EXPECT_DOUBLE_EQ(t[1].azimuth_min_rad, rad_from_deg(-10.0));
  EXPECT_THAT(test::error_text([&] { read("list:\n- {distance_m: 80, azimuth_deg: [5, -5]}\n"); }),
              HasSubstr("a.yaml:2: list.0.azimuth_deg: expected two numbers: from, to"));
  EXPECT_THAT(test::error_text([&] { read("list:\n- {distance_m: 80, distnace: 5}\n"); }),
              HasSubstr("list.0.distnace: unknown key"));
}

}  // namespace
}  // namespace lac::sim
