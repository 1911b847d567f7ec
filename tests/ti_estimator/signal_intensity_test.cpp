// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/signal_intensity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "ti_estimator/correction.hpp"
#include "ti_estimator/disk_coherence.hpp"

namespace lac {
namespace {

constexpr double kStep_s = 0.0125;

SignalIntensityParams params() {
  SignalIntensityParams p;
  p.used = true;
  p.statistics.window_s = 60.0;
  p.statistics.scan_time_s = 0.25;
  p.statistics.beams = p.statistics.gates = 1;
  return p;
}

/// 10 m/s with a sine of 2 m/s and 12 s: five periods in the window.
double sine(double time_s) {
  return 10.0 + 2.0 * std::sin(2.0 * kPi * time_s / 12.0);
}

template <class Signal>
IntensityEstimate run(const SignalIntensityParams& p, double until_s, Signal signal) {
  const SignalIntensity estimator(p);
  SignalIntensity::State state = estimator.initial_state();
  IntensityEstimate e;
  for (int i = 0; i * kStep_s <= until_s + 1e-9; ++i)
    e = estimator.step(signal(i * kStep_s), i * kStep_s, state);
  return e;
}

const double kRatio = 0.2 * std::sqrt(0.5 * 240.0 / 239.0);  // standard deviation over mean

// Nothing before T, then the ratio of standard deviation and mean.
TEST(SignalIntensity, OfASine) {
  EXPECT_FALSE(run(params(), 59.9, sine).valid());
  const IntensityEstimate e = run(params(), 90.0, sine);
  EXPECT_NEAR(e.intensity, kRatio, 1e-5);
  EXPECT_NEAR(e.mean_speed_mps, 10.0, 1e-4);
}

// A signal of 80 % of the wind has the same intensity; what was added is taken off in squares; the
// correction is that of the free wind.
TEST(SignalIntensity, Corrections) {
  SignalIntensityParams p = params();
  p.speed_factor = 1.25;
  p.added_intensity = 0.05;
  p.correction = LookupTable({10.0, 12.0}, {1.0, 2.0});
  const IntensityEstimate e = run(p, 90.0, [](double t) { return 0.88 * sine(t); });
  EXPECT_NEAR(e.mean_speed_mps, 11.0, 1e-4);
  EXPECT_NEAR(e.intensity, 1.5 * std::sqrt(kRatio * kRatio - 0.0025), 2e-5);
}

// Not used, less turbulence than is added, a mean below 0: no estimate.
TEST(SignalIntensity, NoEstimate) {
  SignalIntensityParams p = params();
  p.added_intensity = 0.2;
  EXPECT_FALSE(run(p, 90.0, sine).valid());
  EXPECT_FALSE(run(params(), 90.0, [](double t) { return -sine(t); }).valid());
  p = params();
  p.used = false;
  EXPECT_FALSE(run(p, 90.0, sine).valid());
}

// Gaps that are not numbers are left out; less than half of the window is no estimate.
TEST(SignalIntensity, Gaps) {
  const auto with_gap = [](double gap_s) {
    return [gap_s](double t) {
      return t > 66.0 - 1e-9 && t < 66.0 + gap_s - 1e-9 ? std::nan("") : sine(t);
    };
  };
  EXPECT_NEAR(run(params(), 102.0, with_gap(24.0)).intensity, kRatio, 1e-3);  // two periods
  EXPECT_FALSE(run(params(), 102.0, with_gap(36.0)).valid());
}

// Both limits, and a value of Monte Carlo (5e6 pairs of points of the disk, python): 0.44131 with a
// standard error of 8e-5.
TEST(DiskCoherence, KnownValues) {
  EXPECT_NEAR(disk_coherence(0.0), 1.0, 1e-9);
  EXPECT_NEAR((1.0 - disk_coherence(1e-4)) / 1e-4, 128.0 / (45.0 * kPi), 1e-4);
  EXPECT_NEAR(disk_coherence(1.0), 0.44131, 2.4e-4);
  EXPECT_NEAR(disk_coherence(1000.0) * 1e6 / 2.0, 1.0, 2e-3);
}

// Against a python sum over 4001 frequencies, R = 63 m, 16 m/s, T = 600 s, up to 10 Hz.
TEST(DiskCoherence, RewsVariance) {
  const Correction c{CorrectionParams{}};
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(c.rews_variance(16.0, 1e-6, none), c.u_variance(16.0), 1e-6);
  EXPECT_NEAR(c.rews_variance(16.0, 63.0, none), 0.36622, 4e-4);
  EXPECT_NEAR(c.rews_variance(16.0, 63.0, 0.02), 0.27706, 3e-4);
}

}  // namespace
}  // namespace lac
