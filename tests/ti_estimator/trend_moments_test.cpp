// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/trend_moments.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <random>

namespace lac {
namespace {

struct Sample {
  std::int64_t tick;
  std::int32_t units;
};

/// Least squares in long double, two passes.
double variance_about_line(const std::deque<Sample>& samples) {
  const auto n = static_cast<long double>(samples.size());
  long double t = 0, v = 0, tt = 0, tv = 0, left = 0;
  for (const Sample& s : samples) t += s.tick / n, v += s.units / n;
  for (const Sample& s : samples)
    tt += (s.tick - t) * (s.tick - t), tv += (s.tick - t) * (s.units - v);
  for (const Sample& s : samples) {
    const long double rest = s.units - v - tv / tt * (s.tick - t);
    left += rest * rest;
  }
  const long double unit = RunningMoments::kUnitsPerMps;
  return static_cast<double>(left / (n - 2) / (unit * unit));
}

// An hour at 80 Hz through a window of 10 min, with a trend and a moving origin: no drift against
// two passes over the samples that are in.
TEST(TrendMoments, NoDriftOverAnHour) {
  constexpr int kWindow = 48000;
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, 1.5);
  TrendMoments moments;
  std::deque<Sample> window;
  std::int64_t origin = 0;
  for (std::int64_t i = 0; i < 288000; ++i) {
    const Sample s{i * 64 / 80, RunningMoments::quantise(14.0 + 2e-5 * i + noise(random))};
    if (s.tick - origin > 100000) {
      moments.move_origin(s.tick - origin);
      origin = s.tick;
    }
    moments.add(s.units, s.tick - origin);
    window.push_back(s);
    if (window.size() <= kWindow) continue;
    moments.remove(window.front().units, window.front().tick - origin);
    window.pop_front();
  }
  EXPECT_EQ(moments.speeds().count(), kWindow);
  EXPECT_NEAR(moments.variance_about_trend() / variance_about_line(window), 1.0, 1e-9);
}

// A straight line leaves nothing; without a trend two degrees of freedom are gone, not one.
TEST(TrendMoments, LineAndNoLine) {
  TrendMoments line, zigzag;
  for (int i = 0; i < 101; ++i) {
    line.add(1000000 + 512 * i, 64 * i);
    zigzag.add(i % 2 == 0 ? 65536 : -65536, 64 * i);
  }
  EXPECT_NEAR(line.variance_about_trend(), 0.0, 1e-12);
  EXPECT_GT(line.speeds().variance(), 0.05);
  EXPECT_NEAR(zigzag.variance_about_trend() / zigzag.speeds().variance(), 100.0 / 99.0, 1e-12);
}

// All at one time: there is no trend to speak of.
TEST(TrendMoments, OneTime) {
  TrendMoments moments;
  for (const int units : {65536, 131072, 196608}) moments.add(units, 640);
  EXPECT_DOUBLE_EQ(moments.variance_about_trend(), 1.0);
}

}  // namespace
}  // namespace lac
