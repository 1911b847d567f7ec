// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/correlation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"
#include "sim_harness/analysis/lcg_series.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// numpy.corrcoef at every lag, then the parabola: a known lag of 11 samples in noise.
TEST(CorrelationPeak, AgreesWithNumpy) {
  const std::vector<double> a = test::lcg_series(1100);
  const std::vector<double> x(a.begin(), a.begin() + 600);
  std::vector<double> y;
  for (std::size_t i = 0; i < 600; ++i)
    y.push_back(2.0 * (i < 11 ? a[900 + i] : a[i - 11]) + 0.8 * a[300 + i]);
  const CorrelationPeak p = correlation_peak(x, y, 0.25, 20, 300, {0.0, 10.0});
  EXPECT_NEAR(p.delay_s, 2.751083866417078, 1e-12);
  EXPECT_NEAR(p.correlation, 0.9366170423754127, 1e-12);
  EXPECT_FALSE(p.at_edge);
}

// A smooth signal: the parabola finds a delay between samples; a negative delay as well.
TEST(CorrelationPeak, BetweenSamples) {
  std::vector<double> x, late, early;
  const auto wind = [](double t_s) {
    return std::sin(0.2 * t_s) + 0.5 * std::sin(0.53 * t_s + 1.0);
  };
  for (int i = 0; i < 800; ++i) {
    x.push_back(wind(0.25 * i));
    late.push_back(3.0 + 7.0 * wind(0.25 * i - 6.1));
    early.push_back(wind(0.25 * i + 2.6));
  }
  EXPECT_NEAR(correlation_peak(x, late, 0.25, 100, 300, {0.0, 12.0}).delay_s, 6.1, 0.002);
  EXPECT_NEAR(correlation_peak(x, early, 0.25, 100, 300, {-10.0, 10.0}).delay_s, -2.6, 0.002);
  EXPECT_TRUE(correlation_peak(x, late, 0.25, 100, 300, {0.0, 4.0}).at_edge);
}

// A load that falls when the wind rises: the largest magnitude is negative, if it may be.
TEST(CorrelationPeak, EitherSign) {
  const std::vector<double> x = test::lcg_series(400);
  std::vector<double> y(400);
  for (std::size_t i = 8; i < 400; ++i) y[i] = -3.0 * x[i - 8];
  const CorrelationPeak p = correlation_peak(x, y, 0.5, 20, 300, {0.0, 10.0, PeakSign::kEither});
  EXPECT_NEAR(p.delay_s, 4.0, 0.05);
  EXPECT_NEAR(p.correlation, -1.0, 1e-3);
  EXPECT_GT(correlation_peak(x, y, 0.5, 20, 300, {0.0, 10.0}).correlation, 0.0);
}

// No variation, gaps, no lag that fits: no peak.
TEST(CorrelationPeak, NoPeak) {
  std::vector<double> x = test::lcg_series(100), calm(100, 5.0);
  EXPECT_TRUE(std::isnan(correlation_peak(x, calm, 1.0, 0, 50, {0.0, 5.0}).correlation));
  EXPECT_TRUE(std::isnan(correlation_peak(x, x, 1.0, 60, 40, {1.0, 5.0}).delay_s));
  std::vector<double> gap = x;
  gap[20] = NAN;
  EXPECT_TRUE(std::isnan(correlation_peak(x, gap, 1.0, 0, 50, {0.0, 5.0}).correlation));
}

// 300 samples at 4 Hz with half an overlap over 1000 samples: from 0, 150 ... 600.
TEST(MovingWindows, Places) {
  const auto windows = moving_windows(1000, 0.25, {});
  ASSERT_EQ(windows.size(), 5U);
  EXPECT_EQ(windows[4].first, 600U);
  EXPECT_EQ(windows[4].length, 300U);
  EXPECT_TRUE(moving_windows(299, 0.25, {}).empty());
  EXPECT_THAT(lac::test::error_text([] {
                moving_windows(100, 1.0, {3.0, 0.5});
              }),
              HasSubstr("at least 4 samples"));
  EXPECT_THAT(lac::test::error_text([] {
                moving_windows(100, 1.0, {30.0, 1.0});
              }),
              HasSubstr("overlap of 1.0"));
}

// Means of three, the rest left out.
TEST(BlockMeans, Means) {
  EXPECT_THAT(block_means(std::vector<double>{1, 2, 3, 4, 5, 9, 7}, 3), ElementsAre(2.0, 6.0));
}

// An independent computation of the same definition for a smoothed fixed series (numpy).
TEST(IntegralTimeScale, AgreesWithNumpy) {
  const std::vector<double> a = test::lcg_series(400);
  std::vector<double> smooth;
  for (std::size_t i = 0; i + 8 <= a.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 8; ++k) sum += a[i + k] / 8.0;
    smooth.push_back(sum);
  }
  EXPECT_NEAR(integral_time_scale(smooth, 0.25), 0.8173425912559679, 1e-9);
}

// Whole periods of a sine: the autocorrelation is a cosine, up to a quarter period 1/omega.
TEST(IntegralTimeScale, SineClosedForm) {
  std::vector<double> series;
  for (int i = 0; i < 40000; ++i) series.push_back(3.0 + std::sin(2.0 * kPi * i / 400.0));
  EXPECT_NEAR(integral_time_scale(series, 0.1), 40.0 / (2.0 * kPi), 0.02);
  EXPECT_TRUE(std::isnan(integral_time_scale(std::vector<double>(50, 1.0), 0.1)));
}

// First-order noise of memory T: an exponential autocorrelation, integral scale T; one long record,
// five standard errors (relative about sqrt(2 T (2 ln) / length), 4 % here).
TEST(IntegralTimeScale, RedNoise) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  constexpr double kTime_s = 2.0, kStep_s = 0.25;
  const double memory = std::exp(-kStep_s / kTime_s);
  std::vector<double> series(80000);
  double x = 0.0;
  for (double& value : series) value = x = memory * x + normal(random);
  EXPECT_NEAR(integral_time_scale(series, kStep_s), kTime_s, 0.2 * kTime_s);
}

}  // namespace
}  // namespace lac::sim
