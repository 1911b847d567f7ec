// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/block_transform.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"
#include "sim_harness/analysis/lcg_series.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using Complex = std::complex<double>;

// scipy.signal.csd(x, y, fs=2, window='hamming', nperseg=64, noverlap=32, detrend='linear') of a
// fixed series against its own later part: the mean of conj(X) Y.
TEST(BlockTransform, CrossSpectrumAgreesWithScipy) {
  const std::vector<double> all = test::lcg_series(230);
  const BlockTransform transform(200, 0.5, 64, Taper::kHamming);
  const auto x = transform(std::span(all).first(200)), y = transform(std::span(all).subspan(30));
  ASSERT_EQ(transform.blocks(), 5U);
  const auto cross = [&](std::size_t bin) {
    Complex sum;
    for (std::size_t b = 0; b < 5; ++b) sum += std::conj(x[b * 33 + bin]) * y[b * 33 + bin] / 5.0;
    return sum;
  };
  EXPECT_NEAR(std::abs(cross(5) - Complex{14396.54001441204, 12858.553338193376}), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(cross(16) - Complex{-15829.9645457198, -10746.752110736414}), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(cross(32) - Complex{-6798.94738561663, 0.0}), 0.0, 1e-6);
}

// A series that repeats: a sine of amplitude A is in its own bin alone, A^2/2 over df; the mean in
// bin 0.
TEST(BlockTransform, PeriodicSine) {
  std::vector<double> series(100);
  for (int i = 0; i < 100; ++i) series[i] = 7.0 + 3.0 * std::cos(2.0 * kPi * 0.07 * i + 1.0);
  const BlockTransform transform(100, 0.2, 10, Taper::kNone);
  const auto x = transform(series);
  ASSERT_EQ(transform.blocks(), 1U);
  ASSERT_EQ(x.size(), 51U);
  EXPECT_NEAR(transform.frequency_hz(7), 0.35, 1e-15);
  for (std::size_t k = 1; k < 51; ++k)
    EXPECT_NEAR(std::norm(x[k]) * 0.05, k == 7 ? 4.5 : 0.0, 1e-12) << k;
  EXPECT_NEAR(std::arg(x[7]), 1.0, 1e-12);
}

/// First-order autoregressive noise: a red spectrum with a closed form for sampled series.
struct RedNoise {
  double memory = 0.95;
  double density(double f_hz, double dt_s) const {
    return 2.0 * dt_s / std::norm(1.0 - memory * std::polar(1.0, -2.0 * kPi * f_hz * dt_s));
  }
  std::vector<double> series(std::size_t n, std::mt19937_64& random) const {
    std::normal_distribution<double> normal;
    double x = normal(random) / std::sqrt(1.0 - memory * memory);
    std::vector<double> values(n);
    for (double& value : values) value = x = memory * x + normal(random);
    return values;
  }
};

// The mean of |X|^2 in red noise is the density as the window sees it: 2000 series of 3 blocks,
// four standard errors (5.2 %). At the lowest bin used the window's leakage is 8 % of it.
TEST(BlockTransform, ExpectedDensityOfRedNoise) {
  constexpr int kSeries = 2000;
  const RedNoise noise;
  const BlockTransform transform(256, 0.5, 128, Taper::kHamming);
  std::mt19937_64 random(11);
  std::vector<double> mean(transform.bins());
  for (int i = 0; i < kSeries; ++i) {
    const auto x = transform(noise.series(256, random));
    for (std::size_t k = 0; k < x.size(); ++k)
      mean[k % transform.bins()] += std::norm(x[k]) / (3.0 * kSeries);
  }
  const auto density = [&](double f_hz) { return noise.density(f_hz, 0.5); };
  const double error = 4.0 * std::sqrt(transform.variance_of_mean(3, 4) / kSeries);
  for (const std::size_t k : {3, 4, 6, 10, 20, 50})
    EXPECT_NEAR(mean[k] / transform.expected(k, density), 1.0, error) << k;
  EXPECT_GT(transform.expected(3, density) / density(transform.frequency_hz(3)), 1.04);
}

// Variance of band means of white noise, 2000 series of 5 blocks: within 4 standard errors of a
// variance (sqrt(2 / 2000), 13 %). Counting blocks and bins as independent it would be 35 % less.
TEST(BlockTransform, VarianceOfBandMeans) {
  constexpr int kSeries = 2000;
  const BlockTransform transform(192, 1.0, 64, Taper::kHamming);
  ASSERT_EQ(transform.blocks(), 5U);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kSeries; ++i) {
    std::vector<double> series(192);
    for (double& value : series) value = normal(random);
    const auto x = transform(series);
    double mean = 0.0;
    for (std::size_t b = 0; b < 5; ++b) {
      for (std::size_t k = 5; k < 25; ++k) mean += std::norm(x[b * 33 + k]) / 2.0 / 100.0;
    }
    sum += mean / kSeries;
    squares += mean * mean / kSeries;
  }
  EXPECT_NEAR((squares - sum * sum) / transform.variance_of_mean(5, 25), 1.0, 0.13);
  EXPECT_GT(transform.variance_of_mean(5, 25), 1.35 / 100.0);
}

// Simpson's rule over a bin: exact for the cubic density of a periodic series.
TEST(BlockTransform, ExpectedDensityOfAPeriodicSeries) {
  const BlockTransform transform(100, 0.1, 0, Taper::kNone);
  const double low = 0.25, high = 0.35;  // bin 3 of 0.1 Hz
  const double mean = (std::pow(high, 4) - std::pow(low, 4)) / 4.0 / 0.1;
  EXPECT_NEAR(transform.expected(3, [](double f) { return f * f * f; }), mean, 1e-12);
  EXPECT_DOUBLE_EQ(transform.variance_of_mean(1, 11), 0.1);
}

// A block that does not fit is refused.
TEST(BlockTransform, RefusesBlocksThatDoNotFit) {
  EXPECT_THAT(lac::test::error_text([] { BlockTransform(100, 0.1, 101, Taper::kHamming); }),
              ::testing::HasSubstr("block of 101 samples for a series of 100"));
}

}  // namespace
}  // namespace lac::sim
