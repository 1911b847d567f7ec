// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/spectrum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/analysis/lcg_series.hpp"

namespace lac::sim {
namespace {

double integral(const Spectrum& s) {
  const double df_hz = s.frequency_hz[1];
  return df_hz * std::accumulate(s.density.begin(), s.density.end(), 0.0);
}

std::vector<double> white_noise(std::size_t samples, double sigma) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, sigma);
  std::vector<double> series(samples);
  for (double& x : series) x = normal(random);
  return series;
}

// scipy.signal.welch(fs=2, window='hamming', nperseg=64, noverlap=32, detrend='linear') for a
// fixed series, first, inner and Nyquist frequency.
TEST(Welch, AgreesWithScipy) {
  const Spectrum s = welch(test::lcg_series(200), 0.5, 64);
  ASSERT_EQ(s.frequency_hz.size(), 33U);
  EXPECT_DOUBLE_EQ(s.frequency_hz[5], 0.15625);
  EXPECT_DOUBLE_EQ(s.frequency_hz[32], 1.0);
  EXPECT_NEAR(s.density[0], 8180.157806241669, 1e-6);
  EXPECT_NEAR(s.density[1], 62930.998788382145, 1e-6);
  EXPECT_NEAR(s.density[5], 94334.66961331556, 1e-6);
  EXPECT_NEAR(s.density[16], 93029.60888456629, 1e-6);
  EXPECT_NEAR(s.density[32], 23392.595773212197, 1e-6);
}

// The same with an odd block, where no frequency is its own mirror but 0.
TEST(Welch, AgreesWithScipyForAnOddBlock) {
  const Spectrum s = welch(test::lcg_series(200), 0.5, 51);
  ASSERT_EQ(s.frequency_hz.size(), 26U);
  EXPECT_NEAR(s.density[1], 55049.71006930401, 1e-6);
  EXPECT_NEAR(s.density[5], 67572.99629420035, 1e-6);
  EXPECT_NEAR(s.density[25], 78888.42887452136, 1e-6);
}

// A sine of amplitude A holds the variance A^2/2 around its frequency, on any mean and trend.
TEST(Welch, SineVarianceAndFrequency) {
  std::vector<double> series;
  for (int i = 0; i < 8192; ++i) {
    const double t_s = 0.0125 * i;
    series.push_back(50.0 + 0.3 * t_s + 3.0 * std::sin(2.0 * kPi * 2.5 * t_s));
  }
  const Spectrum s = welch(series, 0.0125, 2048);
  const auto peak = std::max_element(s.density.begin(), s.density.end()) - s.density.begin();
  EXPECT_NEAR(s.frequency_hz[static_cast<std::size_t>(peak)], 2.5, 1e-12);
  EXPECT_NEAR(integral(s), 4.5, 0.01);
}

// White noise of variance sigma^2 has the density 2 sigma^2 dt everywhere. With 1023 blocks at
// 50 % overlap (effective number about 0.8 of it) a bin scatters by 3.5 %: 5 sigma = 18 %; the
// mean over 120 bins within 5 sigma = 1.6 %.
TEST(Welch, WhiteNoiseLevel) {
  const double sigma = 2.0, dt_s = 0.1;
  const Spectrum s = welch(white_noise(131072, sigma), dt_s, 256);
  const double level = 2.0 * sigma * sigma * dt_s;
  double mean = 0.0;
  for (std::size_t k = 4; k < 124; ++k) {
    EXPECT_NEAR(s.density[k] / level, 1.0, 0.18) << "bin " << k;
    mean += s.density[k] / level / 120.0;
  }
  EXPECT_NEAR(mean, 1.0, 0.016);
}

// Parseval: for one block the integral is the window-weighted variance of the detrended series,
// here a cosine symmetric about the middle of the block: no mean, no trend.
TEST(Welch, ParsevalForOneBlock) {
  const std::size_t n = 64;
  std::vector<double> series(n);
  for (std::size_t i = 0; i < n; ++i) {
    series[i] = std::cos(2.0 * kPi * 8.0 * (static_cast<double>(i) + 0.5) / n);
  }
  double weighted = 0.0, power = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double w = 0.54 - 0.46 * std::cos(2.0 * kPi * static_cast<double>(i) / n);
    weighted += w * w * series[i] * series[i];
    power += w * w;
  }
  EXPECT_NEAR(integral(welch(series, 0.5, n)), weighted / power, 1e-12);
}

// Binning keeps the level, thins out the high frequencies alone and drops f = 0.
TEST(LogBinned, MeansOverBins) {
  Spectrum s;
  for (int k = 0; k <= 1000; ++k) {
    s.frequency_hz.push_back(0.01 * k);
    s.density.push_back(k % 2 == 0 ? 1.0 : 3.0);
  }
  const Spectrum binned = log_binned(s, 10);
  EXPECT_LT(binned.density.size(), 32U);
  EXPECT_DOUBLE_EQ(binned.frequency_hz.front(), 0.01);
  EXPECT_DOUBLE_EQ(binned.density.front(), 3.0);
  EXPECT_TRUE(std::is_sorted(binned.frequency_hz.begin(), binned.frequency_hz.end()));
  const std::size_t inner = binned.density.size() - 3;  // a bin of more than 100 values
  EXPECT_NEAR(binned.density[inner], 2.0, 0.02);
}

// A record shorter than one block says both lengths.
TEST(Welch, TooShortSeriesIsRefused) {
  EXPECT_THAT(
      [] { welch(std::vector<double>(100), 0.1, 128); },
      ::testing::ThrowsMessage<Error>(::testing::HasSubstr("block of 128 samples for a series of "
                                                           "100")));
}

}  // namespace
}  // namespace lac::sim
