// SPDX-License-Identifier: Apache-2.0
#include "feedback/speed_filter.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace lac {
namespace {

using Complex = std::complex<double>;

constexpr double kTimeStep_s = 0.0125;
constexpr double kRated_radps = 122.91;

SpeedFilter::Params params() {
  SpeedFilter::Params p;
  p.low_pass_hz = 0.5;
  p.gearbox_ratio = 97.0;
  p.min_speed_radps = 70.0;
  p.max_speed_radps = 245.0;
  return p;
}

/// Complex gain for a small oscillation about a mean speed.
Complex gain(double mean_radps, double frequency_hz) {
  const SpeedFilter filter(params(), kTimeStep_s);
  SpeedFilter::State state;
  const double w = radps_from_hz(frequency_hz);
  const int first = 80 * 200;
  const int count = static_cast<int>(std::lround(40.0 / (frequency_hz * kTimeStep_s)));
  Complex sum = 0.0;
  for (int i = 0; i < first + count; ++i) {
    const double t = i * kTimeStep_s;
    const double out = filter.step(mean_radps + 0.1 * std::cos(w * t), state) - mean_radps;
    if (i >= first) sum += out * std::exp(Complex(0.0, -w * t));
  }
  return 20.0 * sum / static_cast<double>(count);
}

Complex expected(double mean_radps, double frequency_hz) {
  const Complex s(0.0, radps_from_hz(frequency_hz));
  const double w_c = radps_from_hz(0.5);
  const double w_n = 3.0 * mean_radps / 97.0;
  const double b = radps_from_hz(0.1);
  return w_c / (s + w_c) * (s * s + 0.01 * b * s + w_n * w_n) / (s * s + b * s + w_n * w_n);
}

// Low-pass times notch at 3P of that speed. 80 Hz is fast enough for the analogue formula; the
// notch centre is known to 0.1 %, which its flank of 0.1 Hz width turns into at most 0.02.
TEST(SpeedFilter, IsLowPassTimesNotchAt3P) {
  for (const double mean : {90.0, kRated_radps}) {
    for (const double f : {0.02, 0.1, 0.4, 0.625, 2.0}) {
      EXPECT_NEAR(std::abs(gain(mean, f) - expected(mean, f)), 0.0, 0.02) << mean << " " << f;
    }
  }
}

// The blade-passing frequency disappears, at low speed as at rated.
TEST(SpeedFilter, TakesOut3P) {
  for (const double mean : {90.0, kRated_radps}) {
    const double f = SpeedFilter::notch_centre_hz(params(), mean);
    EXPECT_NEAR(f, 3.0 * mean / (2.0 * kPi * 97.0), 1e-12);
    EXPECT_LT(std::abs(gain(mean, f)), 0.03) << mean;
  }
}

// Starts settled; a slow run-up of the speed leaves only the lag of the low-pass, 1/w_c.
TEST(SpeedFilter, FollowsARampWithTheLagOfTheLowPass) {
  const SpeedFilter filter(params(), kTimeStep_s);
  SpeedFilter::State state;
  EXPECT_EQ(filter.step(90.0, state), 90.0);
  double out = 0.0;
  double speed = 90.0;
  for (int i = 1; i <= 80 * 300; ++i) {
    speed = 90.0 + 0.1 * i * kTimeStep_s;
    out = filter.step(speed, state);
  }
  // The notch adds (1 - D) b/w_n^2.
  const double w_n = 3.0 * speed / 97.0;
  const double lag_s = 1.0 / radps_from_hz(0.5) + 0.99 * radps_from_hz(0.1) / (w_n * w_n);
  EXPECT_NEAR(speed - out, 0.1 * lag_s, 0.05 * 0.1 * lag_s);
}

// The coefficients stay while the slow speed moves by less than 0.1 %, and change beyond it.
TEST(SpeedFilter, RecomputesOnlyWhenTheCentreMoved) {
  const SpeedFilter filter(params(), kTimeStep_s);
  SpeedFilter::State state;
  filter.step(100.0, state);
  for (int i = 0; i < 80 * 300; ++i) filter.step(100.09, state);
  EXPECT_EQ(state.centre_radps, 100.0);
  for (int i = 0; i < 80 * 300; ++i) filter.step(100.5, state);
  EXPECT_NEAR(state.centre_radps, 100.45, 0.06);
}

// At standstill the notch waits at the lowest speed.
TEST(SpeedFilter, StandstillIsNoDivisionByZero) {
  const SpeedFilter filter(params(), kTimeStep_s);
  SpeedFilter::State state;
  EXPECT_EQ(filter.step(0.0, state), 0.0);
  EXPECT_EQ(state.centre_radps, 70.0);
}

}  // namespace
}  // namespace lac
