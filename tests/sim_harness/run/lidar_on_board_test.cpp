// SPDX-License-Identifier: Apache-2.0
// Weaknesses switched on in a case, seen in what the lidar on board says: each against its closed
// form, in steady wind of 18 m/s over the NREL 5 MW.
#include "sim_harness/run/lidar_on_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "sim_harness/run/probe_case.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

constexpr double kWind_mps = 18.0;
constexpr double kRadius_m = 63.0;
constexpr double kStep_s = 0.0125;

/// Two gates of a point lidar straight up-wind, a beam every 0.25 s.
constexpr char kOnTheAxis[] =
    "beam_azimuth_deg: [0], beam_elevation_deg: [0], gates_m: [50, 120], gates_along: beam, "
    "beam_time_s: 0.25, fwhm_m: 0";

/// A case with a lidar of these keys and weaknesses, and its wind.
class OnBoard {
 public:
  OnBoard(const std::string& lidar, const std::string& weaknesses, const std::string& more = {})
      : c_(load_case(files_.file("outputs:", "lidar: {" + lidar + ", weaknesses: {" + weaknesses +
                                                 "}}\n" + more + "outputs:"))),
        wind_(make_wind(c_.wind)),
        lidar_(c_, *wind_) {}

  /// Steps on until something new is there.
  const LidarMeasurement& next(const TurbineState& turbine = {}) {
    while (!lidar_.measure(step_++, turbine)) {
    }
    return lidar_.measurement();
  }
  bool step(const TurbineState& turbine = {}) { return lidar_.measure(step_++, turbine); }
  const LidarMeasurement& measurement() const { return lidar_.measurement(); }
  double now_s() const { return kStep_s * static_cast<double>(step_ - 1); }
  const Case& c() const { return c_; }
  const WindField& wind() const { return *wind_; }

 private:
  test::ProbeCase files_;
  Case c_;
  std::unique_ptr<WindField> wind_;
  LidarOnBoard lidar_;
  std::int64_t step_ = 0;
};

void expect_same(const LidarMeasurement& a, const LidarMeasurement& b) {
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.beam_id, b.beam_id);
  EXPECT_EQ(a.beam_dir_L, b.beam_dir_L);
  EXPECT_EQ(a.position_I_m, b.position_I_m);
  EXPECT_EQ(a.velocity_I_mps, b.velocity_I_mps);
  EXPECT_EQ(a.pitch_rad, b.pitch_rad);
  ASSERT_EQ(a.gate_count, b.gate_count);
  for (std::size_t g = 0; g < static_cast<std::size_t>(a.gate_count); ++g) {
    EXPECT_EQ(a.gates[g].speed_mps, b.gates[g].speed_mps);
    EXPECT_EQ(a.gates[g].valid, b.gates[g].valid);
    EXPECT_EQ(a.gates[g].cnr_db, b.gates[g].cnr_db);
  }
}

// All off: to the last bit what the lidar alone says, on a tower that moves.
TEST(LidarOnBoard, OffIsTheLidarAlone) {
  OnBoard on_board("file: " LAC_SOURCE_DIR "/config/lidars/four_beam_pulsed.yaml",
                   "induction: {model: none}");
  LidarSim alone(on_board.c().lidar->params, on_board.wind(), {90.0, kStep_s, 20.0});
  LidarMeasurement m;
  int seen = 0;
  for (int n = 0; n < 400; ++n) {
    const TurbineState turbine{.tower_x_m = 0.3 * std::sin(0.1 * n),
                               .tower_v_mps = 0.4 * std::cos(0.1 * n),
                               .azimuth_rad = 0.01 * n,
                               .thrust_coefficient = 0.6};
    const bool is_new = alone.step(n, turbine, m);
    ASSERT_EQ(on_board.step(turbine), is_new);
    if (!is_new) continue;
    expect_same(on_board.measurement(), m);
    ++seen;
  }
  EXPECT_EQ(seen, 19);
}

// On the axis both models are the closed form, counted from the rotor wherever the tower is.
TEST(LidarOnBoard, InductionOnTheAxis) {
  for (const std::string model : {"one_dimensional", "vortex_cylinder"}) {
    OnBoard on_board(kOnTheAxis, "induction: {model: " + model + ", thrust_coefficient: 0.75}");
    const LidarMeasurement& m = on_board.next({.tower_x_m = 1.5});
    for (const int g : {0, 1}) {
      const double xi = -(g == 0 ? 50.0 : 120.0) / kRadius_m;
      EXPECT_NEAR(m.gates[static_cast<std::size_t>(g)].speed_mps,
                  kWind_mps * (1.0 - 0.25 * (1.0 + xi / std::sqrt(1.0 + xi * xi))), 1e-12);
    }
  }
}

// Off the axis, and following the turbine: 120 m along a beam 20 deg to the left (-y) the wind of
// the vortex cylinder, projected on the beam (what blows outwards blows along it), with a of C_T =
// 0.64 (a = 0.2).
TEST(LidarOnBoard, InductionOffTheAxis) {
  OnBoard on_board(
      "beam_azimuth_deg: [20], beam_elevation_deg: [0], gates_m: [120], gates_along: beam, "
      "beam_time_s: 0.25, fwhm_m: 0",
      "induction: {model: vortex_cylinder, thrust_coefficient: turbine}");
  const double ca = std::cos(rad_from_deg(20.0)), sa = std::sin(rad_from_deg(20.0));
  const UnitInduction unit = vortex_cylinder_induction(-120.0 * ca, 120.0 * sa, kRadius_m);
  const double u = kWind_mps * (1.0 - 0.2 * unit.axial);
  const double outwards = 0.2 * kWind_mps * unit.radial;
  EXPECT_NEAR(on_board.next({.thrust_coefficient = 0.64}).gates[0].speed_mps,
              u * ca - outwards * sa, 1e-12);
  EXPECT_GT(outwards, 0.1);
}

constexpr char kNacelle[] = "file: " LAC_SOURCE_DIR "/config/lidars/four_beam_nacelle.yaml";

// The share of blocked measurements of each beam over a whole turn, against the geometry done by
// hand: the beam crosses the rotor plane at (y, z); near there the blade is a cylinder (root) and
// the beam oblique, so that it sees a little more of it than a flat plate would show.
TEST(LidarOnBoard, BladesInEachBeam) {
  OnBoard on_board(
      kNacelle, "blade_blockage: {blade: " LAC_SOURCE_DIR "/config/turbines/nrel5mw/blade.yaml}");
  constexpr int kTurn = 1440;
  std::array<double, 4> lost{};
  for (int k = 0; k < 4 * kTurn; ++k) {
    // 4 beams see the same azimuth, then the next one
    const LidarMeasurement& m = on_board.next({.azimuth_rad = 2.0 * kPi * (k / 4) / kTurn});
    lost[static_cast<std::size_t>(m.beam_id)] += m.gates[0].valid ? 0.0 : 1.0 / kTurn;
    for (std::size_t g = 0; g < 10; ++g) EXPECT_EQ(m.gates[g].valid, m.gates[0].valid);
  }
  const double y_m = 8.0 * std::tan(rad_from_deg(14.4));
  const double up_m = 8.0 * std::tan(rad_from_deg(14.0)) / std::cos(rad_from_deg(14.4));
  const double r_up_m = std::hypot(y_m, 5.0 + up_m), r_down_m = std::hypot(y_m, 5.0 - up_m);
  const auto share = [](double chord_m, double r_m) {
    return 3.0 / kPi * std::asin(0.5 * chord_m / r_m);
  };
  EXPECT_NEAR(lost[0], share(4.05, r_up_m), 0.02);
  EXPECT_NEAR(lost[3], share(4.05, r_up_m), 0.02);
  EXPECT_NEAR(lost[1], share(3.65, r_down_m), 0.05);
  EXPECT_NEAR(lost[2], share(3.65, r_down_m), 0.05);
  EXPECT_GT(lost[1], lost[0] + 0.1);
}

// Mean CNR over range as handed to the controller, and the same share of valid gates as the
// normal distribution has above the threshold.
TEST(LidarOnBoard, CarrierToNoise) {
  OnBoard on_board(kOnTheAxis,
                   "carrier_to_noise: {reference_db: -10, reference_range_m: 50, scatter_db: 2, "
                   "threshold_db: -16}");
  constexpr int kCount = 4000;
  double sum_db[2] = {}, valid[2] = {};
  for (int k = 0; k < kCount; ++k) {
    const LidarMeasurement& m = on_board.next();
    for (std::size_t g = 0; g < 2; ++g) {
      sum_db[g] += m.gates[g].cnr_db / kCount;
      valid[g] += m.gates[g].valid ? 1.0 / kCount : 0.0;
    }
  }
  const double far_db = -10.0 - 20.0 * std::log10(120.0 / 50.0);
  const double error_db = 4.5 * 2.0 / std::sqrt(kCount);
  EXPECT_NEAR(sum_db[0], -10.0, error_db);
  EXPECT_NEAR(sum_db[1], far_db, error_db);
  const double expected = 0.5 * std::erfc((-16.0 - far_db) / 2.0 / std::sqrt(2.0));
  EXPECT_NEAR(valid[1], expected, 4.5 * std::sqrt(expected * (1.0 - expected) / kCount));
}

// Outages and noise at their given share and size, the wind being steady.
TEST(LidarOnBoard, OutagesAndNoise) {
  OnBoard on_board(kOnTheAxis,
                   "outages: {share: 0.1, burst_share: 0.2, burst_length_s: 1}, "
                   "speed_noise: {sigma_mps: 0.25}");
  constexpr int kCount = 8000;
  double lost = 0.0, square = 0.0;
  for (int k = 0; k < kCount; ++k) {
    const LidarMeasurement& m = on_board.next();
    lost += m.gates[0].valid ? 0.0 : 1.0;
    if (m.gates[0].valid) square += std::pow(m.gates[0].speed_mps - kWind_mps, 2);
  }
  const double share = 0.1 + 0.2 - 0.02;
  const double rho = 1.0 - 0.25 - 0.25 * 0.25;  // of the bursts, mean length 4 measurements
  const double variance = 0.81 * 0.16 * (1.0 + rho) / (1.0 - rho) + 0.09 * 0.8;
  EXPECT_NEAR(lost / kCount, share, 4.5 * std::sqrt(variance / kCount));
  const double valid = kCount - lost;
  EXPECT_NEAR(square / valid / 0.0625, 1.0, 4.5 * std::sqrt(2.0 / valid));
}

// A mast at the first gate, standing for a while: the lidar's own motion along the beam, then the
// wind again. The tower moves up-wind at 0.5 m/s: +0.5 m/s.
TEST(LidarOnBoard, HardTarget) {
  OnBoard on_board(kOnTheAxis, "hard_targets: [{distance_m: 50, cnr_db: 60, end_s: 0.5}]");
  const TurbineState turbine{.tower_v_mps = -0.5};
  const LidarMeasurement& m = on_board.next(turbine);
  EXPECT_NEAR(m.gates[0].speed_mps, 0.5, 1e-4);
  EXPECT_TRUE(m.gates[0].valid);
  EXPECT_FALSE(m.gates[1].valid);
  on_board.next(turbine);
  EXPECT_NEAR(m.gates[0].speed_mps, kWind_mps + 0.5, 1e-12);
  EXPECT_TRUE(m.gates[1].valid);
}

// Measured at 0.25 s and 0.5 s, stamped 0.1 s late and a hundredth too fast, delivered 4 steps
// later.
TEST(LidarOnBoard, Clock) {
  OnBoard on_board(kOnTheAxis, "clock: {offset_s: 0.1, drift_ppm: 10000, latency_steps: 4}");
  EXPECT_NEAR(on_board.next().time_s, 0.25 + 0.1 + 0.0025, 1e-12);
  EXPECT_NEAR(on_board.now_s(), 0.3, 1e-12);
  EXPECT_NEAR(on_board.next().time_s, 0.5 + 0.1 + 0.005, 1e-12);
  EXPECT_NEAR(on_board.now_s(), 0.55, 1e-12);
}

// The seed of the case is that of the weaknesses.
TEST(LidarOnBoard, Seed) {
  const auto first = [](const char* seed) {
    OnBoard on_board(kOnTheAxis, "speed_noise: {sigma_mps: 0.25}", seed);
    return on_board.next().gates[0].speed_mps;
  };
  EXPECT_EQ(first("seed: 3\n"), first("seed: 3\n"));
  EXPECT_NE(first("seed: 3\n"), first("seed: 4\n"));
}

// Faults in the keys name file, line and key; those that need the lidar name the lidar.
TEST(LidarOnBoard, BadKeys) {
  EXPECT_THAT(test::error_text([] { OnBoard(kOnTheAxis, "inducton: {model: none}"); }),
              HasSubstr("lidar.weaknesses.inducton: unknown key (did you mean 'induction'?)"));
  EXPECT_THAT(test::error_text([] { OnBoard(kOnTheAxis, "induction: {model: vortex}"); }),
              HasSubstr("lidar.weaknesses.induction.model: found 'vortex', expected none, "
                        "one_dimensional or vortex_cylinder"));
  EXPECT_THAT(test::error_text([] {
                OnBoard(kOnTheAxis, "blade_blockage: {blade: " LAC_SOURCE_DIR
                                    "/config/turbines/nrel5mw/blade.yaml}");
              }),
              HasSubstr("the lidar lies in the rotor plane or ahead of it"));
  EXPECT_THAT(test::error_text(
                  [] { OnBoard(kOnTheAxis, "outages: {burst_share: 0.1, burst_length_s: 0.1}"); }),
              HasSubstr("a measurement every 0.25 s; expected a mean length of at least 0.25 s"));
}

}  // namespace
}  // namespace lac::sim
