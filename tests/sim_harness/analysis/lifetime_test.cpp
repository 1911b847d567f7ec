// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/lifetime.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/units.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Rayleigh with the mean of class I, closed form: 1 - exp(-pi/4 (v/10)^2); half of the time below
// the median 10 sqrt(4 ln 2 / pi).
TEST(WindDistribution, Rayleigh) {
  const WindDistribution wind = WindDistribution::rayleigh(10.0);
  EXPECT_NEAR(wind.probability_below(10.0 * std::sqrt(4.0 * std::log(2.0) / kPi)), 0.5, 1e-15);
  EXPECT_NEAR(wind.probability_below(4.0), 1.0 - std::exp(-kPi / 4.0 * 0.16), 1e-15);
  EXPECT_EQ(wind.probability_below(-1.0), 0.0);
  double mean_mps = 0.0;  // of the distribution, trapezoids of 1 - F
  for (int i = 0; i <= 6000; ++i)
    mean_mps += (i == 0 ? 0.5 : 1.0) * 0.01 * (1.0 - wind.probability_below(0.01 * i));
  EXPECT_NEAR(mean_mps, 10.0, 1e-6);
  EXPECT_NEAR((WindDistribution{9.0, 1.5}.probability_below(9.0)), 1.0 - std::exp(-1.0), 1e-15);
}

// Bins of the fatigue cases, 4 to 24 m/s in steps of 2: edges 3, 5 ... 25, and so the whole from 3
// to 25 m/s.
TEST(BinProbabilities, FatigueCases) {
  const WindDistribution wind = WindDistribution::rayleigh(8.5);
  std::vector<double> speeds_mps;
  for (double v = 4.0; v < 25.0; v += 2.0) speeds_mps.push_back(v);
  const std::vector<double> p = bin_probabilities(wind, speeds_mps);
  EXPECT_NEAR(p[0], wind.probability_below(5.0) - wind.probability_below(3.0), 1e-15);
  EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0),
              wind.probability_below(25.0) - wind.probability_below(3.0), 1e-15);
}

// Uneven steps: half way; not below 0; one speed alone.
TEST(BinProbabilities, UnevenAndSingle) {
  const WindDistribution wind = WindDistribution::rayleigh(10.0);
  const auto between = [&](double a, double b) {
    return wind.probability_below(b) - wind.probability_below(a);
  };
  const std::vector<double> p = bin_probabilities(wind, std::vector<double>{1.0, 8.0, 12.0});
  EXPECT_DOUBLE_EQ(p[0], between(0.0, 4.5));
  EXPECT_DOUBLE_EQ(p[1], between(4.5, 10.0));
  EXPECT_DOUBLE_EQ(p[2], between(10.0, 14.0));
  EXPECT_THAT(bin_probabilities(wind, std::vector<double>{16.0}),
              ElementsAre(::testing::DoubleEq(between(15.0, 17.0))));
  EXPECT_THAT(test::error_text([&] {
                bin_probabilities(wind, std::vector<double>{8.0, 8.0});
              }),
              HasSubstr("wind speeds must rise"));
}

// By hand: loads 2 and 3 with m = 4 and shares 0.5 and 0.25; equal loads are their own mean.
TEST(LifetimeLoad, ByHand) {
  const std::vector<double> loads{2.0, 3.0}, shares{0.5, 0.25};
  EXPECT_NEAR(lifetime_load(loads, shares, 4.0), std::pow(8.0 + 81.0 / 4.0, 0.25), 1e-14);
  EXPECT_NEAR(mean_load(loads, 4.0), std::pow((16.0 + 81.0) / 2.0, 0.25), 1e-14);
  EXPECT_NEAR(mean_load(std::vector<double>(6, 7.0), 10.0), 7.0, 1e-13);
  EXPECT_NEAR(annual_energy(loads, shares), 8760.0 * 1.75, 1e-10);
  EXPECT_THAT(test::error_text([&] { annual_energy(loads, std::vector<double>{1.0}); }),
              HasSubstr("2 values for 1 bins"));
}

}  // namespace
}  // namespace lac::sim
