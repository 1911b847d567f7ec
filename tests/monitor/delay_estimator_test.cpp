// SPDX-License-Identifier: Apache-2.0
// Two signals in a box: what went in comes out. Lags, noise and spectra are known.
#include "monitor/delay_estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <random>

#include "monitor/band_spectra.hpp"
#include "monitor/random_wind.hpp"

namespace lac {
namespace {

constexpr double kTick_s = 0.2;
constexpr std::size_t kRange = 30;
constexpr std::size_t kSpacing = 5;
constexpr std::size_t kMargin = 25;

/// Wind, and the same wind `lag_s` later with noise of its own on either.
LaggedMoments box(double lag_s, double noise_mps, unsigned seed, int ticks = 3000) {
  const test::RandomWind wind(seed, 0.0, 1.0);
  std::mt19937 random(seed + 100);
  std::normal_distribution<double> noise(0.0, noise_mps);
  LaggedMoments m(kRange + kMargin, kMargin);
  for (int n = 0; n < ticks; ++n) {
    const double t = n * kTick_s;
    m.add(wind.at(t) + noise(random), wind.at(t - lag_s) + noise(random), 1.0 / (n + 1.0));
  }
  return m;
}
double moddemeijer_delay_s(const LaggedMoments& m) {
  const Moddemeijer estimator(kRange, kSpacing, kTick_s);
  Moddemeijer::State state = estimator.initial_state();
  for (std::size_t i = 0; i < 2 * kRange + 1; ++i) estimator.step(m, state);
  return state.delay_s;
}

// The recursion against sums over all products, forgetting as weights.
TEST(LaggedMomentsTest, AreWhatTheySay) {
  std::mt19937 random(3);
  const auto number = [&] { return static_cast<double>(random() % 1000) / 500.0 - 1.0; };
  std::vector<double> x, y;
  LaggedMoments m(4, 3);
  const double share = 0.1;
  for (int n = 0; n < 60; ++n) {
    x.push_back(number());
    y.push_back(number());
    m.add(x.back(), y.back(), share);
  }
  const auto mean = [&](const std::vector<double>& a, const std::vector<double>& b, int lag) {
    double sum = 0.0;  // of a(t) b(t + lag), the time of b in the middle of the memory
    for (int n = 4; n < 56; ++n) {
      sum += share * std::pow(1.0 - share, 55 - n) * a[static_cast<std::size_t>(n - lag)] *
             b[static_cast<std::size_t>(n)];
    }
    return sum;
  };
  for (int lag = -4; lag <= 4; ++lag) EXPECT_NEAR(m.cross(lag), mean(x, y, lag), 1e-12) << lag;
  for (int lag = 0; lag <= 3; ++lag) {
    EXPECT_NEAR(m.auto_x(static_cast<std::size_t>(lag)), mean(x, x, lag), 1e-12);
    EXPECT_NEAR(m.auto_y(static_cast<std::size_t>(lag)), mean(y, y, lag), 1e-12);
  }
}

// After a gap no product spans it.
TEST(LaggedMomentsTest, NothingAcrossAGap) {
  LaggedMoments m(2, 0);
  for (int n = 0; n < 10; ++n) m.add(1.0, 1.0, 0.5);
  m.break_off();
  EXPECT_FALSE(m.filled());
  const double before = m.cross(0);
  for (int n = 0; n < 4; ++n) m.add(100.0, 100.0, 0.5);
  EXPECT_EQ(m.cross(0), before);
  m.add(100.0, 100.0, 0.5);
  EXPECT_GT(m.cross(0), 1000.0);
}

// Hardly any noise: either way, between the ticks.
TEST(Delay, FoundByBothMethods) {
  for (const double lag_s : {-3.0, -0.7, 0.0, 1.0, 2.33, 5.0}) {
    const LaggedMoments m = box(lag_s, 0.1, 5);
    EXPECT_NEAR(correlation_delay(m, kRange, kTick_s).delay_s, lag_s, 0.05);
    EXPECT_NEAR(correlation_delay(m, kRange, kTick_s).correlation, 1.0 / 1.01, 0.01);
    EXPECT_NEAR(moddemeijer_delay_s(m), lag_s, 0.1) << lag_s;
  }
}

// With noise of half the wind's standard deviation on both, ten boxes: mean and spread.
TEST(Delay, SpreadInNoise) {
  for (const auto& method : std::vector<std::function<double(const LaggedMoments&)>>{
           [](const LaggedMoments& m) { return correlation_delay(m, kRange, kTick_s).delay_s; },
           moddemeijer_delay_s}) {
    double sum = 0.0, squares = 0.0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const double error_s = method(box(1.4, 0.5, seed)) - 1.4;
      sum += error_s;
      squares += error_s * error_s;
    }
    RecordProperty("rms", std::to_string(std::sqrt(squares / 10)));
    std::cout << "mean error " << sum / 10 << " s, rms " << std::sqrt(squares / 10) << " s\n";
    EXPECT_LT(std::abs(sum / 10), 0.3);
    EXPECT_LT(std::sqrt(squares / 10), 0.6);
  }
}

// A lag beyond the range has its peak at the end: no delay; nor have signals that do not vary.
TEST(Delay, NoneRatherThanTheEdge) {
  EXPECT_TRUE(std::isnan(correlation_delay(box(9.0, 0.0, 5), kRange, kTick_s).delay_s));
  const LaggedMoments still(kRange + kMargin, kMargin);
  EXPECT_TRUE(std::isnan(correlation_delay(still, kRange, kTick_s).delay_s));
  EXPECT_EQ(correlation_delay(still, kRange, kTick_s).correlation, 0.0);
  EXPECT_TRUE(std::isnan(moddemeijer_delay_s(still)));
}

/// ln det of the covariances of n samples of a first-order process, and white noise.
double ln_det(std::size_t n, double correlation, double noise) {
  std::vector<std::vector<double>> a(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      a[i][j] = std::pow(correlation, std::abs(static_cast<double>(i) - static_cast<double>(j)));
    }
    a[i][i] += noise;
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    sum += std::log(a[k][k]);
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t j = n; j-- > k;) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
    }
  }
  return sum;
}

// Two independent first-order processes: what the past tells of the future is the sum of what each
// tells, with the noise that the estimator adds (3 %); without noise -1/2 ln(1 - r^2) each.
TEST(ModdemeijerTest, InformationOfFirstOrderProcesses) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal(0.0, 1.0);
  const double r_x = 0.8, r_y = 0.5;
  LaggedMoments m(8, 5);
  double x = 0.0, y = 0.0;
  for (int n = 0; n < 200000; ++n) {
    x = r_x * x + std::sqrt(1.0 - r_x * r_x) * normal(random);
    y = r_y * y + std::sqrt(1.0 - r_y * r_y) * normal(random);
    m.add(x, y, 1.0 / (n + 1.0));
  }
  const auto information = [](double r, double noise) {
    return ln_det(Moddemeijer::kSamples, r, noise) -
           0.5 * ln_det(2 * Moddemeijer::kSamples, r, noise);
  };
  EXPECT_NEAR(information(r_x, 0.0), -0.5 * std::log(1.0 - r_x * r_x), 1e-12);
  const double expected = information(r_x, 0.03) + information(r_y, 0.03);
  EXPECT_NEAR(Moddemeijer(2, 1, 1.0).information(m, 1), expected, 0.02 * expected);
}

// The same wind, late and smaller: coherence 1, slope as made.
TEST(BandSpectraTest, WindOfKnownDelayAndGain) {
  BandSpectra s({0.02, 0.035, 0.05}, 0.01, kTick_s);
  const test::RandomWind wind(4, 0.0, 1.0);
  for (int n = 0; n < 4000; ++n) {
    const double t = n * kTick_s;
    s.add(wind.at(t), 0.8 * wind.at(t - 0.9), 1.0 / (n + 1.0));
  }
  EXPECT_GT(s.mean_coherence(1.0), 0.97);
  double expected = 0.0, weight = 0.0;
  for (const auto& b : s.bands()) {
    expected += b.xx * 0.8 * std::cos(radps_from_hz(b.frequency_hz) * 0.9);
    weight += b.xx;
  }
  EXPECT_NEAR(s.slope(800.0).value, expected / weight, 0.02);
}

// Noise of known share: coherence S^2/((S + N)(S + N)) by the share in the bands; independent
// signals stay at what chance leaves of some 15 bandwidth-times.
TEST(BandSpectraTest, CoherenceInNoise) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, 1.0);
  BandSpectra half({0.05, 0.1, 0.15}, 0.02, kTick_s), none = half;
  for (int n = 0; n < 60000; ++n) {
    const double common = normal(random), a = normal(random), b = normal(random);
    half.add(common + a, common + b, 1.0 / (n + 1.0));
    none.add(a, b, 1.0 / (n + 1.0));
  }
  EXPECT_NEAR(half.mean_coherence(1.0), 0.25, 0.04);
  EXPECT_LT(none.mean_coherence(1.0), 0.01);
}

// The stated deviation of the slope is that of many records, within a third.
TEST(BandSpectraTest, DeviationOfTheSlope) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal(0.0, 1.0);
  const int records = 300, ticks = 1500;  // 300 s each
  double sum = 0.0, squares = 0.0, stated = 0.0;
  for (int k = 0; k < records; ++k) {
    BandSpectra s({0.02, 0.05, 0.08}, 0.01, kTick_s);
    for (int n = 0; n < ticks; ++n) {
      const double x = normal(random);
      s.add(x, x + normal(random), 1.0 / (n + 1.0));
    }
    const BandSpectra::Slope slope = s.slope(ticks * kTick_s);
    sum += slope.value;
    squares += slope.value * slope.value;
    stated += slope.deviation / records;
  }
  const double mean = sum / records, deviation = std::sqrt(squares / records - mean * mean);
  std::cout << "slope " << mean << " +- " << deviation << ", stated " << stated << '\n';
  EXPECT_NEAR(mean, 1.0, 4.0 * deviation / std::sqrt(records));
  EXPECT_NEAR(stated, deviation, deviation / 3.0);
}

// Bands above the cut-off do not count, the lowest always does.
TEST(BandSpectraTest, BandsUpToTheCutOff) {
  BandSpectra s({0.02, 0.05}, 0.005, kTick_s);
  for (int n = 0; n < 6000; ++n) {
    const double t = n * kTick_s, w = radps_from_hz(0.02);
    const double high = std::sin(radps_from_hz(0.05) * t + 3e-4 * t * t);
    s.add(std::sin(w * t) + high, std::sin(w * t) + 0.3 * std::sin(radps_from_hz(0.052) * t),
          1.0 / (n + 1.0));
  }
  EXPECT_GT(s.mean_coherence(0.03), 0.9);
  EXPECT_EQ(s.mean_coherence(0.03), s.mean_coherence(0.001));
  EXPECT_LT(s.mean_coherence(0.06), 0.75);
}

}  // namespace
}  // namespace lac
