// SPDX-License-Identifier: Apache-2.0
#include "core/order_watch.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/openfast_lidar_host.hpp"

namespace lac {
namespace {

using Finding = OrderWatch::Finding;

/// Feeds ten minutes of a random staircase; gives the one finding and where it points.
std::pair<Finding, int> watched(int host_order, int told_order, int hold, double spread_mps,
                                int told_hold = 1) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0.0, spread_mps);
  test::OpenFastLidarHost host;
  host.order = host_order;
  OrderWatch watch;
  std::pair<Finding, int> result{Finding::None, -1};
  double x[4] = {16.0, 16.0, 16.0, 16.0};
  for (int k = 0; k < 96000; ++k) {
    x[3] = x[2], x[2] = x[1], x[1] = x[0];
    if (k % hold == 0) x[0] = 16.0 + 0.9 * (x[0] - 16.0) + normal(random);
    const auto y = static_cast<float>(host.extrapolated(x[1], x[2], x[3]));
    const Finding f = watch.step(static_cast<double>(y), told_order, (k - 1) % told_hold == 0);
    if (f == Finding::None) continue;
    EXPECT_EQ(result.first, Finding::None) << "said twice";
    result = {f, watch.best_order()};
  }
  return result;
}

// A wrong order is found, and the right one named, for every pair and update rate, in strong wind
// and in almost none.
TEST(OrderWatch, FindsTheOrder) {
  for (const int hold : {2, 8, 40, 160}) {
    for (const double spread_mps : {0.5, 0.05}) {
      for (int host = 0; host <= 2; ++host) {
        for (int told = 0; told <= 2; ++told) {
          const auto [finding, best] = watched(host, told, hold, spread_mps);
          EXPECT_EQ(finding, host == told ? Finding::None : Finding::OtherOrder)
              << "host " << host << " told " << told << " hold " << hold << " " << spread_mps;
          if (finding == Finding::OtherOrder) {
            EXPECT_EQ(best, host);
          }
        }
      }
    }
  }
}

// Values that change at every call tell nothing; nor does wind that hardly changes at all.
TEST(OrderWatch, SaysNothingWithoutEvidence) {
  for (int host = 0; host <= 2; ++host) {
    for (int told = 0; told <= 2; ++told) {
      EXPECT_EQ(watched(host, told, 1, 0.5).first, Finding::None) << host << told;
      EXPECT_EQ(watched(host, told, 40, 1e-4).first, Finding::None) << host << told;
    }
  }
}

// Updates that come at other times than the schedule says.
TEST(OrderWatch, FindsOtherTimes) {
  EXPECT_EQ(watched(2, 2, 40, 0.5, 40).first, Finding::None);
  EXPECT_EQ(watched(2, 2, 40, 0.5, 80).first, Finding::OtherTimes);
  EXPECT_EQ(watched(2, 2, 40, 0.5, 32).first, Finding::OtherTimes);
  EXPECT_EQ(watched(1, 2, 40, 0.5, 40).first, Finding::OtherOrder);
}

}  // namespace
}  // namespace lac
