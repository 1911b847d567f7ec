// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/inflow_windows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/error_text.hpp"

namespace lac::sim {
namespace {

/// Red wind of mean 12 m/s and 10 % turbulence at 4 Hz; a load that follows it by 7 s.
InflowSeries follow_by_seven_seconds() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  InflowSeries s;
  double x = 0.0;
  for (int i = 0; i < 2000; ++i) {
    x = 0.95 * x + std::sqrt(1.0 - 0.95 * 0.95) * normal(random);
    s.wind.push_back(12.0 + 1.2 * x);
    s.load.push_back(i < 28 ? 0.0 : 5.0 * s.wind[static_cast<std::size_t>(i - 28)]);
    s.power.push_back(5000.0);
    s.pitch.push_back(i < 1000 ? 0.0 : 6.0);
  }
  return s;
}

ModeRule rule() {
  ModeRule r;
  r.rated_power = 5000.0;
  return r;
}

// Every window finds the delay, its mode and its turbulence; windows whose load would end are left
// out and counted.
TEST(InflowWindows, DelayAndMode) {
  const InflowSeries s = follow_by_seven_seconds();
  const InflowWindows found = inflow_windows(s, {}, {0.0, 20.0}, rule());
  ASSERT_EQ(found.windows.size(), 11U);  // starts 0, 150 ... 1500; the twelfth is cut
  EXPECT_EQ(found.incomplete, 1U);
  for (const InflowWindow& w : found.windows) {
    EXPECT_NEAR(w.peak.delay_s, 7.0, 0.125);  // half a sample: rough noise peaks in a cusp
    EXPECT_NEAR(w.peak.correlation, 1.0, 1e-6);
    EXPECT_NEAR(w.speed_mps, 12.0, 1.0);
    EXPECT_NEAR(w.intensity, 0.1, 0.04);
    EXPECT_NEAR(w.length_scale_m, w.time_scale_s * w.speed_mps, 1e-9);
  }
  EXPECT_EQ(found.windows[0].mode, OperatingMode::kBelowRated);
  EXPECT_EQ(found.windows[5].mode, OperatingMode::kMixed);
  EXPECT_EQ(found.windows[8].mode, OperatingMode::kAboveRated);
  EXPECT_EQ(found.windows[1].start_s, 37.5);
}

// A gap takes the windows that it touches.
TEST(InflowWindows, Gap) {
  InflowSeries s = follow_by_seven_seconds();
  s.wind[700] = NAN;  // in the windows that start at 450 and 600
  const InflowWindows found = inflow_windows(s, {}, {0.0, 20.0}, rule());
  EXPECT_EQ(found.windows.size(), 9U);
  EXPECT_EQ(found.incomplete, 3U);
  s.load.pop_back();
  EXPECT_THAT(test::error_text([&] { inflow_windows(s, {}, {}, rule()); }),
              ::testing::HasSubstr("series of 2000, 1999, 2000 and 2000 samples"));
}

// Quartiles as numpy gives them, and the fullest bin; what is not finite is left out.
TEST(Typical, QuartilesAndBins) {
  const std::vector<double> v{0.62, 0.71, NAN, 0.73, 0.74, 0.9};
  const Typical t = typical(v, 0.05);
  EXPECT_NEAR(t.lower_quartile, 0.71, 1e-15);
  EXPECT_NEAR(t.median, 0.73, 1e-15);
  EXPECT_NEAR(t.upper_quartile, 0.74, 1e-15);
  EXPECT_NEAR(t.bin_from, 0.7, 1e-12);
  EXPECT_NEAR(t.bin_to, 0.75, 1e-12);
  EXPECT_NEAR(t.bin_share, 0.6, 1e-15);
  EXPECT_TRUE(std::isnan(typical({}, 1.0).median));
  EXPECT_NEAR(typical(std::vector<double>{1, 2, 3, 4}, 1.0).lower_quartile, 1.75, 1e-15);
}

}  // namespace
}  // namespace lac::sim
