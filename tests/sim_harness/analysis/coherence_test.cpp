// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/coherence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim_harness/analysis/lcg_series.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

// scipy.signal.coherence and csd (fs 4, Hamming, 64 samples, overlap 32, detrend linear) of a fixed
// series and a mixture of it with its own later part.
TEST(CrossSpectrum, AgreesWithScipy) {
  const std::vector<double> all = test::lcg_series(1050);
  std::vector<double> y;
  for (std::size_t i = 0; i < 1000; ++i) y.push_back(0.7 * all[i] + 0.3 * all[i + 50]);
  CrossSpectrumEstimator estimator(0.25, 64);
  ASSERT_TRUE(estimator.add(std::span(all).first(1000), y));
  const CrossSpectrum s = estimator.result();
  EXPECT_EQ(s.frequency_hz[0], 0.1875);  // bin 3
  EXPECT_NEAR(s.coherence[0], 0.8169632874616064, 1e-12);
  EXPECT_NEAR(s.coherence[7], 0.8713794514845387, 1e-12);
  EXPECT_NEAR(s.coherence[28], 0.8873392590617571, 1e-12);
  EXPECT_NEAR(std::abs(s.cross[7] - std::complex(31187.989928146057, -7119.393905606466)), 0.0,
              1e-7);
}

// A stretch in two pieces is the mean over all their blocks; pieces shorter than a block do
// nothing.
TEST(CrossSpectrum, ManyStretches) {
  const std::vector<double> all = test::lcg_series(600);
  const auto part = [&](std::size_t first, std::size_t n) {
    return std::span(all).subspan(first, n);
  };
  CrossSpectrumEstimator first(0.25, 64), second(0.25, 64), both(0.25, 64);
  first.add(part(0, 128), part(10, 128));    // 3 blocks
  second.add(part(300, 64), part(310, 64));  // 1 block
  both.add(part(0, 128), part(10, 128));
  EXPECT_FALSE(both.add(part(0, 63), part(10, 63)));
  both.add(part(300, 64), part(310, 64));
  EXPECT_EQ(both.blocks(), 4U);
  const double expected = 0.75 * first.result().density_x[5] + 0.25 * second.result().density_x[5];
  EXPECT_NEAR(both.result().density_x[5], expected, 1e-9);
  EXPECT_NEAR(second.result().independent_blocks, 1.0, 1e-12);
  EXPECT_GT(both.result().independent_blocks, first.result().independent_blocks + 0.8);
  EXPECT_LT(both.result().independent_blocks, 4.0);
}

/// y = x + noise of its own, both white: gamma^2 = 1 / (1 + ratio).
CrossSpectrum noisy(double ratio, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> x(1088), y(1088);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = normal(random);
    y[i] = x[i] + std::sqrt(ratio) * normal(random);
  }
  CrossSpectrumEstimator estimator(1.0, 64);
  estimator.add(x, y);
  return estimator.result();
}

// 500 pairs of series of 33 blocks: the bands hold the true density 2 and the true coherence in 95
// % (with 29 neighbouring bins each, four standard deviations of a binomial with half as many
// independent ones are 1 %; the theory of the coherence is approximate: 1 % more).
TEST(Bands, Coverage) {
  std::mt19937_64 random(2);
  for (const double truth : {0.4, 0.8}) {
    double dense = 0.0, coherent = 0.0, all = 0.0;
    for (int i = 0; i < 500; ++i) {
      const CrossSpectrum s = noisy(1.0 / truth - 1.0, random);
      const Band d = density_band(s.density_x, s.independent_blocks, 0.95);
      const Band c = coherence_band(s.coherence, s.independent_blocks, 0.95);
      for (std::size_t k = 0; k < s.coherence.size(); ++k) {
        dense += d.low[k] <= 2.0 && 2.0 <= d.high[k];
        coherent += c.low[k] <= truth && truth <= c.high[k];
        all += 1.0;
      }
    }
    EXPECT_NEAR(dense / all, 0.95, 0.01) << truth;
    EXPECT_NEAR(coherent / all, 0.95, 0.02) << truth;
  }
}

// Independent series stay below the limit of chance in 95 % of the bins; their band reaches 0.
TEST(Bands, Chance) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  double below = 0.0, all = 0.0;
  for (int i = 0; i < 300; ++i) {
    std::vector<double> x(1088), y(1088);
    for (double& v : x) v = normal(random);
    for (double& v : y) v = normal(random);
    CrossSpectrumEstimator estimator(1.0, 64);
    estimator.add(x, y);
    const CrossSpectrum s = estimator.result();
    const double limit = coherence_by_chance(s.independent_blocks, 0.95);
    for (const double c : s.coherence) {
      below += c < limit;
      all += 1.0;
    }
  }
  EXPECT_NEAR(below / all, 0.95, 0.015);
  EXPECT_EQ(coherence_band(std::vector{0.01}, 20.0, 0.95).low[0], 0.0);
}

// Linear between two frequencies; none if it starts below or stays above.
TEST(FirstFall, Crossing) {
  const std::vector<double> f{0.1, 0.2, 0.3, 0.4}, c{0.9, 0.6, 0.2, 0.5};
  EXPECT_NEAR(first_fall_hz(f, c, 0.4), 0.25, 1e-15);
  EXPECT_TRUE(std::isnan(first_fall_hz(f, c, 0.95)));
  EXPECT_TRUE(std::isnan(first_fall_hz(f, c, 0.1)));
}

// The shortest block has one frequency; a shorter one would have none.
TEST(CrossSpectrum, ShortestBlock) {
  CrossSpectrumEstimator e(1.0, kLeastBlock);
  const std::vector<double> x{1, 3, 2, 5, 4, 7, 1};
  e.add(x, x);
  EXPECT_EQ(e.result().frequency_hz, std::vector{3.0 / 7.0});
  for (const std::size_t block : {0U, 3U, 4U, 6U}) {
    EXPECT_THAT(lac::test::error_text([&] { CrossSpectrumEstimator(1.0, block); }),
                HasSubstr("samples is too short, expected at least 7"));
  }
}

// What cannot be used is refused.
TEST(CrossSpectrum, Faults) {
  CrossSpectrumEstimator e(1.0, 8);
  const std::vector<double> x(8, 1.0), y(9, 1.0), gap{1, 2, 3, NAN, 1, 2, 3, 4};
  EXPECT_THAT(lac::test::error_text([&] { e.add(x, y); }), HasSubstr("series of 8 and 9 samples"));
  EXPECT_THAT(lac::test::error_text([&] { e.add(x, gap); }), HasSubstr("sample 3 is not a finite"));
  EXPECT_THAT(lac::test::error_text([&] { e.result(); }),
              HasSubstr("no stretch is as long as a block"));
  EXPECT_THAT(lac::test::error_text([&] { coherence_band(x, 1.0, 0.95); }),
              HasSubstr("more than one independent block"));
}

}  // namespace
}  // namespace lac::sim
