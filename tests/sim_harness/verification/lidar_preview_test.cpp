// SPDX-License-Identifier: Apache-2.0
// A simulated lidar in evolving fields against spectra that python/lidar_correlation.py integrates
// from the models, interpolation between grid points included: what it printed is in
// tests/data/lidar_correlation, the command in the first line. Seeds are fixed.
// docs/verification.md has the long runs.
#include "tests/sim_harness/verification/lidar_preview.hpp"

#include <gtest/gtest.h>

#include <string>

#include "sim_harness/analysis/block_transform.hpp"
#include "sim_harness/wind/kaimal_field.hpp"
#include "sim_harness/wind/mann_field.hpp"
#include "sim_harness/wind/stability.hpp"
#include "tests/sim_harness/verification/correlation_table.hpp"
#include "tests/sim_harness/verification/evolving_field.hpp"

namespace lac::sim {
namespace {

constexpr double kSpeed_mps = 16.0;
constexpr double kRadius_m = 63.0;
constexpr double kHub_m = 90.0;
constexpr double kStep_s = 5.0 / 6.0;
constexpr std::size_t kSamples = 768;
constexpr int kRealisations = 16;
constexpr double kHighest_hz = 0.3;

/// 53 to 173 m, whole steps of the wind.
std::vector<double> gates() {
  std::vector<double> gates_m;
  for (const int steps : {4, 7, 10, 13}) gates_m.push_back(steps * kSpeed_mps * kStep_s);
  return gates_m;
}

template <class Params>
Params field_params() {
  Params p;
  p.mean_speed_mps = kSpeed_mps;
  p.hub_height_m = kHub_m;
  p.ny = p.nz = 9;
  p.dt_s = kStep_s;
  p.duration_s = kStep_s * kSamples;
  p.threads = 1;
  return p;
}

KaimalFieldParams kaimal_field(LateralCoherence lateral) {
  auto p = field_params<KaimalFieldParams>();
  p.model = stability_kaimal(Stability::kNeutral, kStabilitySigmaU_mps);
  p.evolution = stability_evolution(Stability::kNeutral);
  p.lateral_coherence = lateral;
  return p;
}

/// The box is four times as wide as the field.
MannFieldParams mann_field() {
  auto p = field_params<MannFieldParams>();
  p.model = stability_mann(Stability::kNeutral);
  p.box_ny = p.box_nz = 32;
  return p;
}

template <class Planes>
PairComparison rotor_and_lidar(Planes planes, const std::string& table_file) {
  const BlockTransform transform(kSamples, kStep_s, kSamples, Taper::kNone);
  PairComparison comparison(
      lidar_densities(LAC_SOURCE_DIR "/tests/data/lidar_correlation/" + table_file, transform,
                      kHighest_hz),
      transform.frequency_hz(1));
  const LidarParams lidar = preview_lidar(gates(), kStep_s);
  for (int seed = 1; seed <= kRealisations; ++seed) {
    planes.restart(seed);
    const EvolvingWind wind = evolving_field(planes, gates());
    comparison.add(transform(rotor_speed(wind, kRadius_m, kHub_m, kStep_s, kSamples)),
                   transform(lidar_estimate(wind, lidar, kHub_m, kSamples)));
  }
  return comparison;
}

/// One value in 20 is outside of the limits on average, three in 20 by chance once in a thousand
/// times; twice the limits are nearly four standard deviations.
void expect_agreement(const PairComparison& c) {
  std::size_t values = 0, outside = 0;
  for (const auto& bands : {c.power_a(), c.power_b(), c.coherence(), c.transfer()}) {
    for (const ComparedBand& band : bands) {
      ++values;
      if (!band.inside()) ++outside;
      EXPECT_TRUE(band.inside(2.0))
          << band.frequency_hz << " Hz: " << band.found << ", expected " << band.expected;
    }
  }
  EXPECT_GE(values, 50);
  EXPECT_LE(outside, 3 * values / 20);
  EXPECT_TRUE(c.variance_a().inside()) << c.variance_a().found;
  EXPECT_TRUE(c.variance_b().inside()) << c.variance_b().found;
  EXPECT_NEAR(half_coherence_ratio(c.coherence()), 1.0, 0.05);
}

// Kaimal, v and w as coherent as u: spectra of REWS and estimate, coherence, transfer function.
TEST(LidarPreview, Kaimal) {
  expect_agreement(rotor_and_lidar(KaimalPlanes(kaimal_field(LateralCoherence::kSameAsU)),
                                   "kaimal_neutral.txt"));
}

// The same with v and w independent from point to point.
TEST(LidarPreview, KaimalIndependent) {
  expect_agreement(rotor_and_lidar(KaimalPlanes(kaimal_field(LateralCoherence::kIndependent)),
                                   "kaimal_neutral_independent.txt"));
}

// Mann with the space-time tensor.
TEST(LidarPreview, Mann) {
  expect_agreement(rotor_and_lidar(MannPlanes(mann_field()), "mann_neutral.txt"));
}

}  // namespace
}  // namespace lac::sim
