// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/mode_coherence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lac::sim {
namespace {

/// White wind about 10 m/s; above rated a load 6 s behind it with noise of its own, gamma^2 = 0.8;
/// below rated (the first half) a load that knows nothing of it.
InflowSeries half_and_half() {
  std::mt19937_64 random(21);
  std::normal_distribution<double> normal;
  InflowSeries s;
  for (std::size_t i = 0; i < 20000; ++i) {
    s.wind.push_back(10.0 + normal(random));
    const bool above = i >= 10000;
    s.load.push_back(above ? s.wind[i - 24] + 0.5 * normal(random) : normal(random));
    s.power.push_back(5000.0);
    s.pitch.push_back(above ? 8.0 : 0.0);
  }
  return s;
}

ModeRule rule() {
  ModeRule r;
  r.rated_power = 5000.0;
  return r;
}

double mean_coherence(const ModeCoherence& c) {
  double sum = 0.0;
  for (const double v : c.spectrum.coherence) sum += v;
  return sum / static_cast<double>(c.spectrum.coherence.size());
}

// Each mode by itself: the true coherence 0.8 in one, none in the other (65 blocks of 300 samples
// each; the mean over 145 bins scatters by less than 0.01, its bias (1 - gamma^2)^2 / n is as
// small).
TEST(ModeCoherence, ByMode) {
  const InflowSeries s = half_and_half();
  const auto above = mode_coherence(s, OperatingMode::kAboveRated, 6.0, rule(), 75.0);
  ASSERT_TRUE(above);
  EXPECT_EQ(above->blocks, 65U);
  EXPECT_NEAR(mean_coherence(*above), 0.8, 0.02);
  EXPECT_NEAR(above->speed_mps, 10.0, 0.05);
  EXPECT_NEAR(above->sigma_mps, 1.0, 0.03);
  const auto below = mode_coherence(s, OperatingMode::kBelowRated, 6.0, rule(), 75.0);
  EXPECT_NEAR(mean_coherence(*below), 1.0 / below->spectrum.independent_blocks, 0.01);
  EXPECT_FALSE(mode_coherence(s, OperatingMode::kNotProducing, 6.0, rule(), 75.0));
}

// The delay must be taken out first: half a block of delay costs coherence.
TEST(ModeCoherence, DelayCosts) {
  const InflowSeries s = half_and_half();
  const auto aligned = mode_coherence(s, OperatingMode::kAboveRated, 6.0, rule(), 12.0);
  const auto late = mode_coherence(s, OperatingMode::kAboveRated, 0.0, rule(), 12.0);
  EXPECT_LT(mean_coherence(*late), 0.5 * mean_coherence(*aligned));
}

// The two decays differ by the turbulence intensity; levels are read off the same curve.
TEST(ModeCoherence, DecayAndLevels) {
  ModeCoherence c;
  c.speed_mps = 10.0;
  c.sigma_mps = 1.0;
  for (int i = 1; i <= 50; ++i) {
    c.spectrum.frequency_hz.push_back(0.01 * i);
    c.spectrum.coherence.push_back(std::exp(-3.0 * 0.01 * i * 50.0 / 10.0));
    c.spectrum.density_x.push_back(1.0);
  }
  EXPECT_NEAR(c.decay(50.0).decay, 3.0, 1e-5);
  EXPECT_NEAR(c.scaled_decay(50.0).decay, 30.0, 1e-4);
  EXPECT_NEAR(c.fall_hz(0.4), -std::log(0.4) / 15.0, 1e-4);
}

}  // namespace
}  // namespace lac::sim
