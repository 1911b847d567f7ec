// SPDX-License-Identifier: Apache-2.0
#include "core/filters.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <functional>

namespace lac {
namespace {

using Complex = std::complex<double>;

constexpr double kTimeStep_s = 0.0125;

/// Response of a sampled filter to e^{i w t} by correlation over whole periods, once settled.
Complex measured(const std::function<double(double)>& filter, double frequency_hz,
                 double settling_s) {
  const double w = radps_from_hz(frequency_hz);
  const int periods = 20;
  const int first = static_cast<int>(settling_s / kTimeStep_s);
  const int count = static_cast<int>(std::lround(periods / (frequency_hz * kTimeStep_s)));
  Complex sum = 0.0;
  for (int i = 0; i < first + count; ++i) {
    const double t = i * kTimeStep_s;
    const double out = filter(std::cos(w * t));
    if (i >= first) sum += out * std::exp(Complex(0.0, -w * t));
  }
  return 2.0 * sum / static_cast<double>(count);
}

/// The analogue frequency that the bilinear transform, prewarped at `exact_hz`, puts at `hz`.
Complex warped(double hz, double exact_hz) {
  return {0.0, radps_from_hz(exact_hz) * std::tan(kPi * hz * kTimeStep_s) /
                   std::tan(kPi * exact_hz * kTimeStep_s)};
}

// Frequencies with a whole number of samples in 20 periods at 80 Hz.
constexpr double kFrequencies_hz[] = {0.1, 0.5, 1.0, 2.0, 4.0, 10.0};

// Low-pass against w_c/(s + w_c), through the warping of the bilinear transform.
TEST(LowPass1, MatchesTransferFunction) {
  const double cutoff_hz = 0.5;
  const double factor = LowPass1::factor(cutoff_hz, kTimeStep_s);
  const double w_c = radps_from_hz(cutoff_hz);
  for (const double f : kFrequencies_hz) {
    LowPass1 filter;
    const Complex h = measured([&](double u) { return filter.step(u, factor); }, f, 20.0);
    const Complex expected = w_c / (warped(f, cutoff_hz) + w_c);
    EXPECT_NEAR(std::abs(h - expected), 0.0, 1e-9) << f << " Hz";
  }
}

// At the cut-off itself the response is the analogue one: 1/sqrt(2) and -45 deg.
TEST(LowPass1, IsExactAtTheCutOff) {
  const double factor = LowPass1::factor(2.0, kTimeStep_s);
  LowPass1 filter;
  const Complex h = measured([&](double u) { return filter.step(u, factor); }, 2.0, 20.0);
  EXPECT_NEAR(std::abs(h), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(std::arg(h), -kPi / 4.0, 1e-9);
}

// It starts settled, and a changed cut-off does not move a settled output.
TEST(LowPass1, StartsSettledAndSurvivesNewCoefficients) {
  LowPass1 filter;
  EXPECT_EQ(filter.step(7.0, LowPass1::factor(0.1, kTimeStep_s)), 7.0);
  EXPECT_EQ(filter.step(7.0, LowPass1::factor(5.0, kTimeStep_s)), 7.0);
}

// Notch against (s^2 + D b s + w_n^2)/(s^2 + b s + w_n^2) at all frequencies.
TEST(Notch, MatchesTransferFunction) {
  const double centre_hz = 0.5;
  const double bandwidth_hz = 0.2;
  const double depth = 0.25;
  const auto c = Notch::coefficients(centre_hz, bandwidth_hz, depth, kTimeStep_s);
  const double w_n = radps_from_hz(centre_hz);
  const double b = radps_from_hz(bandwidth_hz);
  for (const double f : kFrequencies_hz) {
    Notch filter;
    const Complex h = measured([&](double u) { return filter.step(u, c); }, f, 60.0);
    const Complex s = warped(f, centre_hz);
    const Complex expected = (s * s + depth * b * s + w_n * w_n) / (s * s + b * s + w_n * w_n);
    EXPECT_NEAR(std::abs(h - expected), 0.0, 1e-9) << f << " Hz";
  }
}

// At the centre the gain is the depth, without phase; far away and at rest it is 1.
TEST(Notch, TakesOutTheCentreAlone) {
  const auto c = Notch::coefficients(0.5, 0.1, 0.01, kTimeStep_s);
  Notch filter;
  const Complex h = measured([&](double u) { return filter.step(u, c); }, 0.5, 120.0);
  EXPECT_NEAR(h.real(), 0.01, 1e-9);
  EXPECT_NEAR(h.imag(), 0.0, 1e-9);
  Notch constant;
  for (int i = 0; i < 100; ++i) EXPECT_DOUBLE_EQ(constant.step(122.9, c), 122.9);
}

// A settled notch whose centre moves gives no transient.
TEST(Notch, SurvivesNewCoefficients) {
  Notch filter;
  for (int i = 0; i < 200; ++i) {
    const auto c = Notch::coefficients(0.3 + 0.002 * i, 0.1, 0.01, kTimeStep_s);
    ASSERT_NEAR(filter.step(122.9, c), 122.9, 1e-10);
  }
}

// Width zero is no notch.
TEST(Notch, WidthZeroPassesEverything) {
  const auto c = Notch::coefficients(0.5, 0.0, 0.01, kTimeStep_s);
  Notch filter;
  for (int i = 0; i < 100; ++i) {
    const double u = std::sin(0.1 * i * i);
    ASSERT_EQ(filter.step(u, c), u);
  }
}

// The mean of the first values is the plain one; later it forgets with the window.
TEST(SlowMean, IsExactFirstAndForgetsLater) {
  SlowMean mean;
  for (int i = 1; i <= 100; ++i) {
    mean.add(i, 0.1, 20.0);
    ASSERT_NEAR(mean.mean(), 0.5 * (i + 1), 1e-12);
  }
  SlowMean step;
  for (int i = 0; i < 200; ++i) step.add(0.0, 0.1, 20.0);
  for (int i = 0; i < 200; ++i) step.add(1.0, 0.1, 20.0);
  EXPECT_NEAR(step.mean(), 1.0 - std::pow(1.0 - 0.1 / 20.0, 200), 1e-12);
}

}  // namespace
}  // namespace lac
