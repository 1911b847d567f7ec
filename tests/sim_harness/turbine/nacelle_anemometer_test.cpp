// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/nacelle_anemometer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim_harness/analysis/statistics.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

// Out of the rotor's way it measures the wind, bit by bit.
TEST(NacelleAnemometer, Undisturbed) {
  NacelleAnemometer a({}, 1, 0.0125);
  EXPECT_EQ(a.measure(16.123456789, 0.8), 16.123456789);
}

// C_T = 8/9 is a = 1/3; a change comes in with the lag; more than 0.96 counts as that (a = 0.4).
TEST(NacelleAnemometer, Induction) {
  NacelleAnemometer a({.induction_share = 0.5, .induction_lag_s = 10.0}, 1, 0.01);
  EXPECT_NEAR(a.measure(12.0, 8.0 / 9.0), 12.0 * (1.0 - 0.5 / 3.0), 1e-12);
  double v = 0.0;
  for (int i = 0; i < 1000; ++i) v = a.measure(12.0, 0.0);
  EXPECT_NEAR(v, 12.0 * (1.0 - 0.5 / 3.0 * std::exp(-1.0)), 1e-9);
  NacelleAnemometer most({.induction_share = 1.0}, 1, 0.01);
  EXPECT_NEAR(most.measure(10.0, 1.2), 6.0, 1e-12);
}

// What is added: mean 0, the standard deviation asked for, and the autocorrelation exp(-t / 0.5).
// 20000 s hold 20000 / (2 0.5) independent samples: limits of 4 standard errors.
TEST(NacelleAnemometer, AddedTurbulence) {
  NacelleAnemometer a({.added_intensity = 0.1, .time_scale_s = 0.5}, 3, 0.1);
  std::vector<double> v(200000);
  for (double& x : v) x = a.measure(10.0, 0.5);
  const Statistics s = statistics(v);
  EXPECT_NEAR(s.mean, 10.0, 4.0 / std::sqrt(20000.0));
  EXPECT_NEAR(s.standard_deviation, 1.0, 4.0 / std::sqrt(2.0 * 20000.0 * 2.0));
  double product = 0.0;
  for (std::size_t i = 0; i + 5 < v.size(); ++i) product += (v[i] - 10.0) * (v[i + 5] - 10.0);
  EXPECT_NEAR(product / 200000.0, std::exp(-1.0), 0.04);
}

// The same seed gives the same numbers, another one others.
TEST(NacelleAnemometer, Seed) {
  const NacelleAnemometerParams p{.added_intensity = 0.1};
  NacelleAnemometer a(p, 1, 0.1), b(p, 1, 0.1), c(p, 2, 0.1);
  const double first = a.measure(10.0, 0.0);
  EXPECT_EQ(first, b.measure(10.0, 0.0));
  EXPECT_NE(first, c.measure(10.0, 0.0));
}

TEST(NacelleAnemometer, Refuses) {
  EXPECT_THAT(test::error_text([] { NacelleAnemometer({.added_intensity = 1.5}, 1, 0.1); }),
              ::testing::HasSubstr("nacelle anemometer: added_intensity = 1.5, expected 0 to 1"));
  EXPECT_THAT(test::error_text([] { NacelleAnemometer({.time_scale_s = 0.0}, 1, 0.1); }),
              ::testing::HasSubstr("time_scale_s"));
}

}  // namespace
}  // namespace lac::sim
