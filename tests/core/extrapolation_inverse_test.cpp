// SPDX-License-Identifier: Apache-2.0
#include "core/extrapolation_inverse.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <vector>

namespace lac {
namespace {

/// What a host sends for the values x(k-1), x(k-2), x(k-3), in single precision.
float sent(const std::deque<double>& x, int order) {
  if (order == 1) return static_cast<float>(2.0 * x[0] - x[1]);
  if (order == 2) return static_cast<float>(3.0 * x[0] - 3.0 * x[1] + x[2]);
  return static_cast<float>(x[0]);
}

/// Largest error over a long run of a random staircase that steps every `hold` calls.
double largest_error(int order, int hold, double level, double spread) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(level, spread);
  ExtrapolationInverse inverse;
  std::deque<double> x(3, normal(random));
  inverse.step(sent(x, order), order);
  double worst = 0.0;
  for (int k = 1; k <= 200000; ++k) {
    x.pop_back();
    x.push_front(k % hold == 0 ? normal(random) : x[0]);
    worst = std::max(worst, std::abs(inverse.step(sent(x, order), order) - x[0]));
  }
  return worst;
}

// Speeds come back to 1e-5 m/s and positions to 1e-4 m, whatever the order and the update: the
// bound is 1.1 times half a unit in the last place of the largest value sent.
TEST(ExtrapolationInverse, LongRunsStayExact) {
  for (const int order : {1, 2}) {
    for (const int hold : {1, 2, 3, 7, 40}) {
      EXPECT_LT(largest_error(order, hold, 16.0, 2.0), 5e-6) << order << " " << hold;
      EXPECT_LT(largest_error(order, hold, -205.0, 0.5), 2e-5) << order << " " << hold;
    }
  }
}

// The undone staircase is as flat as single precision allows: nothing that reads as an update.
TEST(ExtrapolationInverse, NoRippleBetweenUpdates) {
  for (const int order : {1, 2}) {
    ExtrapolationInverse inverse;
    std::deque<double> x(3, 60.0);
    inverse.step(sent(x, order), order);
    double last = 60.0;
    for (int k = 1; k < 400; ++k) {
      x.pop_back();
      x.push_front(k % 40 == 0 ? (k % 80 == 0 ? 60.0 : -5.0) : x[0]);
      const double value = inverse.step(sent(x, order), order);
      if (k % 40 != 0) {
        EXPECT_LT(std::abs(value - last), 4e-5) << order << " " << k;
      }
      last = value;
    }
  }
}

// A value that is none is passed on as not a number, and so are the calls in which what was lost
// before it would still be felt; then the values are right again.
TEST(ExtrapolationInverse, BadValuesAreForgotten) {
  for (const double bad : {std::nan(""), 1e30, -HUGE_VAL}) {
    for (const int order : {1, 2}) {
      ExtrapolationInverse inverse;
      std::deque<double> x(3, 16.0);
      for (int k = 0; k < 10; ++k) inverse.step(sent(x, order), order);
      EXPECT_TRUE(std::isnan(inverse.step(bad, order)));
      x = {19.0, 16.0, 16.0};  // begins again in the middle of a spike
      int silent = 0;
      double value = inverse.step(sent(x, order), order);
      for (; std::isnan(value); ++silent) {
        x = {19.0, x[0], x[1]};
        value = inverse.step(sent(x, order), order);
      }
      EXPECT_EQ(silent, ExtrapolationInverse::kSettlingCalls);
      EXPECT_NEAR(value, 19.0, 1e-4) << order;
    }
  }
}

// Order 0 gives every value as it comes, at once also after a bad one.
TEST(ExtrapolationInverse, OrderZeroPassesOn) {
  ExtrapolationInverse inverse;
  EXPECT_EQ(inverse.step(16.0, 0), 16.0);
  EXPECT_TRUE(std::isnan(inverse.step(std::nan(""), 0)));
  EXPECT_EQ(inverse.step(17.5, 0), 17.5);
}

}  // namespace
}  // namespace lac
