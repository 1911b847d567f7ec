// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_weaknesses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/error_text.hpp"
#include "support/no_alloc_guard.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

constexpr int kGates = 10;

/// Beam straight up-wind, 20 m above the rotor axis, gates 40 ... 130 m, wind 10 + gate.
LidarMeasurement measurement(int k) {
  LidarMeasurement m;
  m.time_s = 0.25 * (k + 1);
  m.position_I_m = {5.0, 0.0, 110.0};
  m.velocity_I_mps = {-0.4, 0.0, 0.0};
  m.gate_count = kGates;
  for (int g = 0; g < kGates; ++g) {
    m.gates[static_cast<std::size_t>(g)] = {40.0 + 10.0 * g, 10.0 + g, true, 0.0};
  }
  return m;
}

const TurbineState kTurbine{.azimuth_rad = 1.0, .pitch_rad = 0.1};

/// What pass() makes of it in the step at its own time.
bool pass(LidarWeaknesses& w, LidarMeasurement& m, bool is_new = true,
          const TurbineState& turbine = kTurbine) {
  return w.pass(m.time_s, turbine, m, is_new);
}

LidarWeaknessSetting setting(std::uint64_t seed = 1) {
  LidarWeaknessSetting s;
  s.seed = seed;
  s.position_N_m = {5.0, 0.0, 20.0};
  return s;
}

CarrierToNoiseParams weak_signal() {
  CarrierToNoiseParams p;
  p.enabled = true;
  p.scatter_db = 3.0;
  p.drift_db = 1.0;
  p.threshold_db = -3.0;
  return p;
}

BladeBlockageParams thick_blades() {
  const LookupTable chord({1.0, 60.0}, {6.0, 6.0}), flat({1.0, 60.0}, {0.0, 0.0});
  return {true, {chord, flat, flat}, 0.0};
}

// Everything off: what comes in goes out, to the last bit.
TEST(LidarWeaknesses, OffChangesNothing) {
  LidarWeaknesses weaknesses({}, setting());
  LidarMeasurement m = measurement(3);
  EXPECT_TRUE(pass(weaknesses, m));
  EXPECT_FALSE(pass(weaknesses, m, false));
  EXPECT_EQ(m.time_s, 1.0);
  for (int g = 0; g < kGates; ++g) {
    const LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    EXPECT_EQ(gate.speed_mps, 10.0 + g);
    EXPECT_TRUE(gate.valid);
    EXPECT_EQ(gate.cnr_db, 0.0);
  }
}

// Gates below the threshold are invalid, others are not, and only those carry a speed.
TEST(LidarWeaknesses, Threshold) {
  LidarWeaknessParams p;
  p.carrier_to_noise = weak_signal();
  LidarWeaknesses weaknesses(p, setting());
  int valid = 0, invalid = 0;
  for (int k = 0; k < 100; ++k) {
    LidarMeasurement m = measurement(k);
    ASSERT_TRUE(pass(weaknesses, m));
    for (int g = 0; g < kGates; ++g) {
      const LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
      EXPECT_EQ(gate.valid, gate.cnr_db >= -3.0);
      EXPECT_EQ(gate.valid, std::isfinite(gate.speed_mps));
      (gate.valid ? valid : invalid) += 1;
    }
  }
  EXPECT_GT(valid, 100);
  EXPECT_GT(invalid, 100);
}

// The drift moves on with the time of the measurements.
TEST(LidarWeaknesses, Drift) {
  LidarWeaknessParams p;
  p.carrier_to_noise = weak_signal();
  p.carrier_to_noise.scatter_db = 0.0;
  LidarWeaknesses weaknesses(p, setting());
  LidarMeasurement first = measurement(0), later = measurement(4000);
  pass(weaknesses, first);
  pass(weaknesses, later);
  EXPECT_GT(std::abs(later.gates[3].cnr_db - first.gates[3].cnr_db), 0.1);
}

// A blade of 6 m at 20 m over a revolution: asin(3/20) 3/pi of the measurements lose all gates,
// however low the threshold of their echoes.
TEST(LidarWeaknesses, Blades) {
  LidarWeaknessParams p;
  p.carrier_to_noise.enabled = true;
  p.carrier_to_noise.threshold_db = -60.0;
  p.blade_blockage = thick_blades();
  LidarWeaknesses weaknesses(p, setting());
  int lost = 0;
  for (int k = 0; k < 10000; ++k) {
    LidarMeasurement m = measurement(k);
    pass(weaknesses, m, true, {.azimuth_rad = 2.0 * kPi * k / 10000.0});
    lost += !m.gates[0].valid;
    EXPECT_EQ(m.gates[0].valid, m.gates[9].valid);
    EXPECT_EQ(m.gates[0].valid, m.gates[0].cnr_db > -60.0);
  }
  EXPECT_NEAR(lost / 10000.0, 3.0 / kPi * std::asin(3.0 / 20.0), 6e-4);
}

// An opaque mast at 80 m: the gate there reads the lidar's own motion along the beam, +0.4 m/s, the
// near ones the wind, those more than three standard deviations behind are lost.
TEST(LidarWeaknesses, HardTarget) {
  LidarWeaknessParams p;
  p.hard_targets.push_back({.distance_m = 80.0, .cnr_db = 30.0});
  LidarWeaknessSetting narrow = setting();
  narrow.weighting.fwhm_m = 10.0;
  LidarWeaknesses weaknesses(p, narrow);
  LidarMeasurement m = measurement(0);
  pass(weaknesses, m);
  EXPECT_NEAR(m.gates[4].speed_mps, 0.4, 0.01);
  EXPECT_GT(m.gates[4].cnr_db, 29.9);
  EXPECT_NEAR(m.gates[0].speed_mps, 10.0, 1e-6);
  EXPECT_TRUE(m.gates[0].valid);
  for (std::size_t g = 7; g < kGates; ++g) EXPECT_FALSE(m.gates[g].valid) << g;
}

// What a weaker signal does to the noise: sigma of each gate's error is that of its mean CNR.
TEST(LidarWeaknesses, NoiseFollowsTheSignal) {
  LidarWeaknessParams p;
  p.carrier_to_noise.enabled = true;
  p.carrier_to_noise.threshold_db = -60.0;
  p.speed_noise = {.sigma_mps = 0.1, .doubling_cnr_db = 0.0};
  LidarWeaknesses weaknesses(p, setting());
  constexpr int kMeasurements = 20000;
  double square[2] = {};
  for (int k = 0; k < kMeasurements; ++k) {
    LidarMeasurement m = measurement(k);
    pass(weaknesses, m);
    square[0] += std::pow(m.gates[0].speed_mps - 10.0, 2);
    square[1] += std::pow(m.gates[6].speed_mps - 16.0, 2);
  }
  const double error = 4.5 * std::sqrt(2.0 / kMeasurements);
  const double near_mps = 0.1 * (1.0 + 0.16);  // 40 m against the reference at 100 m
  EXPECT_NEAR(square[0] / kMeasurements / near_mps / near_mps, 1.0, error);
  EXPECT_NEAR(square[1] / kMeasurements / 0.04, 1.0, error);
}

LidarWeaknessParams everything() {
  LidarWeaknessParams p;
  p.carrier_to_noise = weak_signal();
  p.hard_targets.push_back({.distance_m = 80.0});
  p.speed_noise.sigma_mps = 0.2;
  p.blade_blockage = thick_blades();
  p.outages = {.share = 0.1, .per_gate = true, .burst_share = 0.1, .burst_length_s = 2.0};
  p.clock = {.offset_s = 0.1, .latency_steps = 5};
  return p;
}

// The same seed gives the same measurements, another seed others.
TEST(LidarWeaknesses, Seeds) {
  LidarWeaknesses a(everything(), setting(7)), b(everything(), setting(7));
  LidarWeaknesses c(everything(), setting(8));
  int differences = 0;
  for (int k = 0; k < 400; ++k) {
    LidarMeasurement ma = measurement(k), mb = ma, mc = ma;
    const bool is_new = k % 4 == 0;
    ASSERT_EQ(pass(a, ma, is_new), pass(b, mb, is_new));
    pass(c, mc, is_new);
    for (std::size_t g = 0; g < kGates; ++g) {
      ASSERT_EQ(ma.gates[g].cnr_db, mb.gates[g].cnr_db);
      ASSERT_EQ(ma.gates[g].valid, mb.gates[g].valid);
      differences += ma.gates[g].cnr_db != mc.gates[g].cnr_db;
    }
  }
  EXPECT_GT(differences, 500);
}

// Switching one effect on leaves the random numbers of another as they were: the speed noise of
// the gates that remain is the same with outages and blades as without.
TEST(LidarWeaknesses, EffectsDrawOnTheirOwn) {
  LidarWeaknessParams alone;
  alone.speed_noise.sigma_mps = 0.2;
  LidarWeaknessParams among = alone;
  among.outages = {.share = 0.5, .per_gate = true};
  among.blade_blockage = thick_blades();
  LidarWeaknesses a(alone, setting()), b(among, setting());
  int compared = 0;
  for (int k = 0; k < 100; ++k) {
    LidarMeasurement ma = measurement(k), mb = ma;
    pass(a, ma);
    pass(b, mb, true, {.azimuth_rad = 0.1 * k});
    for (std::size_t g = 0; g < kGates; ++g) {
      if (!mb.gates[g].valid) continue;
      EXPECT_EQ(ma.gates[g].speed_mps, mb.gates[g].speed_mps);
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
  EXPECT_LT(compared, 800);
}

TEST(LidarWeaknesses, AllocatesNothing) {
  LidarWeaknesses weaknesses(everything(), setting());
  LidarMeasurement m = measurement(0);
  const test::NoAllocGuard guard;
  for (int k = 0; k < 100; ++k) pass(weaknesses, m, k % 3 == 0);
  EXPECT_EQ(guard.allocations(), 0U);
}

// Beams taken at once are handed over late: the blades stand where they stood at the time of the
// measurement. Blade 1 is in the beam at azimuth 0, one second ago.
TEST(LidarWeaknesses, BladesAtTheTimeOfTheMeasurement) {
  LidarWeaknessParams p;
  p.blade_blockage = thick_blades();
  LidarWeaknesses weaknesses(p, setting());
  for (const bool late : {false, true}) {
    LidarMeasurement m = measurement(0);
    weaknesses.pass(m.time_s + (late ? 1.0 : 0.0), {.azimuth_rad = 0.7, .rotor_speed_radps = 0.7},
                    m, true);
    EXPECT_EQ(m.gates[0].valid, !late);
  }
}

// Blades before a lidar on the spinner or on a nacelle that is not behind the rotor, and a beam
// that is not there, are refused.
TEST(LidarWeaknesses, WhatDoesNotFitTheLidar) {
  LidarWeaknessParams p;
  p.blade_blockage = thick_blades();
  LidarWeaknessSetting s = setting();
  s.turns_with_rotor = true;
  EXPECT_THAT(test::error_text([&] { LidarWeaknesses(p, s); }),
              ::testing::HasSubstr("blade_blockage: no blade passes a lidar on the spinner"));
  s.turns_with_rotor = false;
  s.position_N_m.x = 0.0;
  EXPECT_THAT(test::error_text([&] { LidarWeaknesses(p, s); }),
              ::testing::HasSubstr("blade_blockage: the lidar lies in the rotor plane or ahead"));
  LidarWeaknessParams target;
  target.hard_targets.push_back({.distance_m = 80.0, .beam = 1});
  EXPECT_THAT(test::error_text([&] { LidarWeaknesses(target, s); }),
              ::testing::HasSubstr("hard_targets: beam = 2, expected at most the lidar's 1"));
}

TEST(LidarWeaknesses, Keys) {
  const test::TempFolder folder;
  folder.write(
      "blade.yaml",
      "{radius_m: [1, 60], chord_m: [3, 1], relative_thickness: [1, 0], twist_deg: [9, 0]}");
  YamlReader in = YamlReader::load(
      folder.write("a.yaml",
                   "induction: {model: vortex_cylinder, thrust_coefficient: turbine}\n"
                   "carrier_to_noise: {reference_db: -5, threshold_db: -17}\n"
                   "hard_targets: [{distance_m: 90}]\n"
                   "speed_noise: {sigma_mps: 0.1}\n"
                   "blade_blockage: {blade: blade.yaml}\n"
                   "outages: {share: 0.1}\n"
                   "clock: {latency_steps: 2}\n"));
  const LidarWeaknessParams p = read_lidar_weaknesses(in);
  in.finish();
  EXPECT_EQ(p.induction.model, InductionModel::kVortexCylinder);
  EXPECT_TRUE(p.carrier_to_noise.enabled && p.blade_blockage.enabled && p.outages.enabled() &&
              p.clock.enabled());
  EXPECT_EQ(p.hard_targets.size(), 1U);
  EXPECT_EQ(p.speed_noise.sigma_mps, 0.1);
  YamlReader empty = YamlReader::load(folder.write("b.yaml", "{}\n"));
  const LidarWeaknessParams off = read_lidar_weaknesses(empty);
  EXPECT_FALSE(off.spoils_measurements());
  EXPECT_EQ(off.induction.model, InductionModel::kNone);
}

/// Gate at 80 m of a lidar whose gates are 10 m wide at half maximum, with these targets.
LidarGate gate_at_80_m(const std::vector<HardTarget>& targets) {
  LidarWeaknessParams p;
  p.hard_targets = targets;
  LidarWeaknessSetting narrow = setting();
  narrow.weighting.fwhm_m = 10.0;
  LidarWeaknesses weaknesses(p, narrow);
  LidarMeasurement m = measurement(0);
  pass(weaknesses, m);
  return m.gates[4];
}

// A tree in the gate behind an opaque mast at 45 m is not seen, nor is air there; a mast behind a
// fence at 79 m adds nothing to it, and a net before it adds its whole echo. In any order.
TEST(LidarWeaknesses, TargetsBehindEachOther) {
  const HardTarget mast{.distance_m = 45.0, .cnr_db = 30.0};
  const HardTarget tree{.distance_m = 80.0, .cnr_db = 20.0, .opaque = false};
  const HardTarget fence{.distance_m = 79.0, .cnr_db = 10.0};
  const HardTarget net{.distance_m = 78.0, .cnr_db = 10.0, .opaque = false};
  for (const auto& [near, far] : {std::pair{mast, tree}, std::pair{fence, tree}}) {
    const LidarGate alone = gate_at_80_m({near});
    for (const LidarGate& both : {gate_at_80_m({near, far}), gate_at_80_m({far, near})}) {
      EXPECT_EQ(both.cnr_db, alone.cnr_db);
      EXPECT_EQ(both.valid, alone.valid);
      EXPECT_EQ(std::isnan(both.speed_mps), std::isnan(alone.speed_mps));
    }
  }
  EXPECT_FALSE(gate_at_80_m({mast}).valid);
  const double sigma_m = 10.0 / (2.0 * std::sqrt(2.0 * std::log(2.0)));
  const auto echo = [&](double off_m) {
    return 10.0 * std::exp(-0.5 * std::pow(off_m / sigma_m, 2));
  };
  const double air = 0.5 * std::erfc(1.0 / sigma_m / std::sqrt(2.0));
  const double expected_db = 10.0 * std::log10(echo(1.0) + echo(2.0) + air);
  EXPECT_NEAR(gate_at_80_m({net, fence}).cnr_db, expected_db, 1e-9);
  EXPECT_NEAR(gate_at_80_m({fence, net}).cnr_db, expected_db, 1e-9);
}

// A blade file of another rotor: the tip may be 5 % off the radius, no more.
TEST(LidarWeaknesses, BladeOfAnotherRotor) {
  LidarWeaknessParams p;
  p.blade_blockage = thick_blades();
  LidarWeaknessSetting s = setting();
  for (const double radius_m : {57.2, 60.0, 63.1}) {
    s.rotor_radius_m = radius_m;
    EXPECT_EQ(test::error_text([&] { LidarWeaknesses(p, s); }), "no error");
  }
  for (const double radius_m : {57.1, 63.2, 121.0}) {
    s.rotor_radius_m = radius_m;
    EXPECT_THAT(test::error_text([&] { LidarWeaknesses(p, s); }),
                ::testing::HasSubstr("blade_blockage: blade: its tip is at radius_m = 60"));
  }
}

// A noise that depends on a CNR that nobody models.
TEST(LidarWeaknesses, NoiseWithoutSignal) {
  const test::TempFolder folder;
  const auto read = [&](const std::string& text) {
    YamlReader in = YamlReader::load(folder.write("a.yaml", text));
    read_lidar_weaknesses(in);
    in.finish();
  };
  const std::string noise = "speed_noise:\n  sigma_mps: 0.1\n  doubling_cnr_db: -15\n";
  EXPECT_THAT(test::error_text([&] { read(noise); }),
              ::testing::HasSubstr("a.yaml:3: speed_noise.doubling_cnr_db: without the map "
                                   "carrier_to_noise there is no CNR"));
  EXPECT_EQ(test::error_text(
                [&] { read(noise + "carrier_to_noise: {reference_db: -5, threshold_db: -17}\n"); }),
            "no error");
}

}  // namespace
}  // namespace lac::sim
