// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/exponential_window.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace lac {
namespace {

// Against the sums written out, irregular times included.
TEST(ExponentialMoments, SumsWrittenOut) {
  constexpr double kTimeConstant_s = 20.0;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  ExponentialMoments moments;
  std::vector<double> times_s, values;
  double t_s = 5.0;
  for (int i = 0; i < 400; ++i) {
    times_s.push_back(t_s += any(random));
    values.push_back(15.0 + any(random));
    moments.add(values.back(), t_s, kTimeConstant_s);
  }
  double w = 0.0, ww = 0.0, mean = 0.0, squares = 0.0;
  const auto weight = [&](std::size_t i) {
    return std::exp(-(t_s - times_s[i]) / kTimeConstant_s);
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    w += weight(i), ww += weight(i) * weight(i), mean += weight(i) * values[i];
  }
  mean /= w;
  for (std::size_t i = 0; i < values.size(); ++i) {
    squares += weight(i) * (values[i] - mean) * (values[i] - mean);
  }
  EXPECT_NEAR(moments.mean(), mean, 1e-12);
  EXPECT_NEAR(moments.variance() / (squares / (w - ww / w)), 1.0, 1e-11);
  EXPECT_NEAR(moments.weight(t_s + kTimeConstant_s, kTimeConstant_s), w / std::exp(1.0), 1e-12);
}

// White noise has its variance, without bias: mean of many windows within 3 standard errors.
TEST(ExponentialMoments, WithoutBias) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> noise(10.0, 2.0);
  double sum = 0.0, squares = 0.0;
  constexpr int kRuns = 2000;
  for (int run = 0; run < kRuns; ++run) {
    ExponentialMoments moments;
    for (int i = 0; i < 60; ++i) moments.add(noise(random), i, 6.0);
    sum += moments.variance(), squares += moments.variance() * moments.variance();
  }
  const double mean = sum / kRuns;
  EXPECT_NEAR(mean, 4.0, 3.0 * std::sqrt((squares / kRuns - mean * mean) / kRuns));
}

// A dead lidar: weights fade at the pace of T, each beam is looked at once a scan, and a window
// that was never fed stays silent.
TEST(ExponentialWindow, FadesWithTime) {
  ExponentialWindow window(2, 1, 100.0, 1.0);
  EXPECT_EQ(window.expire(3.0), -1);
  const std::array<std::int32_t, 1> row{RunningMoments::quantise(12.0)};
  for (int i = 0; i < 2000; ++i) window.add(0.5 * i, i % 2, row);
  EXPECT_TRUE(window.has_lasted(999.5));
  EXPECT_NEAR(window.weight(1, 0, 999.5) / window.full_weight(), 1.0, 1e-8);
  EXPECT_NEAR(window.weight(1, 0, 1049.5) / window.full_weight(), std::exp(-1.0), 1e-8);
  std::array<int, 2> looked{};
  for (int i = 1; i <= 800; ++i) {
    const int beam = window.expire(1000.0 + 0.0125 * i);
    if (beam >= 0) ++looked[static_cast<std::size_t>(beam)];
  }
  EXPECT_NEAR(looked[0], 10, 1);
  EXPECT_NEAR(looked[1], 10, 1);
}

}  // namespace
}  // namespace lac
