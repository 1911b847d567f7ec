// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/running_moments.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <limits>
#include <random>
#include <vector>

namespace lac {
namespace {

struct TwoPass {
  double mean = 0.0;
  double variance = 0.0;
};
template <class Samples>
TwoPass two_pass(const Samples& samples) {
  const auto n = static_cast<double>(samples.size());
  long double sum = 0.0L, squares = 0.0L;
  for (const double v : samples) sum += v;
  for (const double v : samples) squares += (v - sum / n) * (v - sum / n);
  return {static_cast<double>(sum / n), static_cast<double>(squares / (n - 1.0))};
}
double as_stored(double v) {
  return RunningMoments::quantise(v) / RunningMoments::kUnitsPerMps;
}

// An hour at 4 Hz through a window of 180 s: the last moments are those of its 720 samples alone.
TEST(RunningMoments, NoDriftOverAnHour) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> wind(16.0, 2.5);
  RunningMoments moments;
  std::deque<double> window;
  for (int i = 0; i < 14400; ++i) {
    const double v = wind(random);
    moments.add(RunningMoments::quantise(v));
    window.push_back(as_stored(v));
    if (window.size() <= 720) continue;
    moments.remove(RunningMoments::quantise(window.front()));
    window.pop_front();
  }
  const TwoPass expected = two_pass(window);
  EXPECT_EQ(moments.count(), 720);
  EXPECT_NEAR(moments.mean_mps() / expected.mean, 1.0, 1e-14);
  EXPECT_NEAR(moments.variance() / expected.variance, 1.0, 1e-12);
}

// A small spread on a large mean, where sums of squares in floating point lose all digits.
TEST(RunningMoments, SmallSpreadOnLargeMean) {
  RunningMoments moments;
  std::vector<double> samples;
  for (int i = 0; i < 60000; ++i) {
    samples.push_back(as_stored(120.0 + 1e-4 * (i % 7)));
    moments.add(RunningMoments::quantise(samples.back()));
  }
  EXPECT_NEAR(moments.variance() / two_pass(samples).variance, 1.0, 1e-9);
}

// The ends of the range, and the largest count, do not overflow: half at +, half at -.
TEST(RunningMoments, EndsOfTheRange) {
  RunningMoments moments;
  const double largest = 127.99999;
  for (int i = 0; i < RunningMoments::kMaxSamples; ++i) {
    moments.add(RunningMoments::quantise(i % 2 == 0 ? largest : -largest));
  }
  EXPECT_NEAR(moments.mean_mps(), 0.0, 1e-12);
  EXPECT_NEAR(moments.standard_deviation_mps(), largest * std::sqrt(65536.0 / 65535.0), 1e-4);
}

// Negative means take the same path.
TEST(RunningMoments, NegativeMean) {
  RunningMoments moments;
  const std::vector<double> samples{-3.0, -4.5, -4.0, 1.25, -7.0};
  for (const double v : samples) moments.add(RunningMoments::quantise(v));
  EXPECT_DOUBLE_EQ(moments.mean_mps(), -3.45);
  EXPECT_NEAR(moments.variance(), two_pass(samples).variance, 1e-12);
}

// What is no speed does not fit.
TEST(RunningMoments, FitsSpeedsOnly) {
  EXPECT_TRUE(RunningMoments::fits(-127.9));
  EXPECT_FALSE(RunningMoments::fits(128.0));
  EXPECT_FALSE(RunningMoments::fits(999.0));
  EXPECT_FALSE(RunningMoments::fits(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(RunningMoments::fits(-std::numeric_limits<double>::infinity()));
}

}  // namespace
}  // namespace lac
