// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/disk_mean.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "core/units.hpp"

namespace lac::sim {
namespace {

using testing::DoubleNear;

constexpr double kRadius_m = 63.0;

/// The same by the midpoint rule over rings and angles of the disk.
double disk_mean_by_rings(double rate_per_m, double distance_m) {
  constexpr int kRings = 800, kAngles = 800;
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double r_m = kRadius_m * std::sqrt((i + 0.5) / kRings);
    for (int j = 0; j < kAngles; ++j) {
      const double a = 2.0 * kPi * (j + 0.5) / kAngles;
      const double apart_m = std::hypot(r_m * std::cos(a) - distance_m, r_m * std::sin(a));
      sum += std::exp(-rate_per_m * apart_m);
    }
  }
  return sum / (kRings * kAngles);
}

// From the centre: 2/(cR)^2 (1 - (1 + cR) e^(-cR)).
TEST(DiskMean, HasItsClosedFormInTheCentre) {
  for (const double x : {1e-5, 0.1, 1.0, 10.0}) {
    const double expected =
        x < 1e-3 ? 1.0 - 2.0 / 3.0 * x : 2.0 * (1.0 - (1.0 + x) * std::exp(-x)) / (x * x);
    EXPECT_NEAR(disk_mean(x / kRadius_m, kRadius_m, 0.0), expected, 1e-9) << x;
  }
}

// Points inside, on the rim and outside, against a sum over the disk.
TEST(DiskMean, AgreesWithASumOverTheDisk) {
  for (const double distance_m : {20.0, 62.0, 63.0, 64.0, 100.0}) {
    for (const double rate : {0.004, 0.02, 0.1}) {
      const double expected = disk_mean_by_rings(rate, distance_m);
      EXPECT_NEAR(disk_mean(rate, kRadius_m, distance_m), expected, 1e-5 + 2e-4 * expected)
          << distance_m << " m, " << rate;
    }
  }
}

// Without decay every mean is 1; a rotor without radius is a point.
TEST(DiskMean, HasItsLimits) {
  EXPECT_NEAR(disk_mean(0.0, kRadius_m, 30.0), 1.0, 1e-7);
  EXPECT_NEAR(disk_mean_of_pairs(0.0, kRadius_m), 1.0, 1e-7);
  EXPECT_DOUBLE_EQ(disk_mean(0.02, 0.0, 30.0), std::exp(-0.6));
  EXPECT_NEAR(disk_mean_of_pairs(0.02, 0.0), 1.0, 1e-7);
}

// Over pairs it is the mean over the disk of the mean from a point.
TEST(DiskMean, OfPairsIsTheMeanOfTheMeans) {
  constexpr int kRings = 400;
  for (const double rate : {0.004, 0.02, 0.1}) {
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i)
      sum += disk_mean(rate, kRadius_m, kRadius_m * std::sqrt((i + 0.5) / kRings)) / kRings;
    EXPECT_NEAR(disk_mean_of_pairs(rate, kRadius_m), sum, 1e-5) << rate;
  }
}

}  // namespace
}  // namespace lac::sim
