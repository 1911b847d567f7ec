// SPDX-License-Identifier: Apache-2.0
#include "ldp/arrival_bins.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace lac {
namespace {

// Against a plain map that sums the window anew each time: the same to the last bit of 2^-20.
TEST(ArrivalBins, AgreesWithASumMadeAnew) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> speed(-5.0, 40.0);
  std::uniform_int_distribution<int> ahead(0, 199), jump(-3, 3), often(0, 4);
  ArrivalBins bins(200);
  std::multimap<std::int64_t, double> all;
  std::int64_t front = 100;
  for (std::int64_t now = 0; now < 20000; ++now) {
    bins.advance(now);
    all.erase(all.begin(), all.lower_bound(now));
    if (often(random) == 0) {
      const std::int64_t arrival = now + ahead(random);
      const double v = std::round(speed(random) * 1048576.0) / 1048576.0;
      ASSERT_TRUE(bins.add(arrival, v));
      all.emplace(arrival, v);
    }
    front = std::clamp<std::int64_t>(front + 1 + jump(random), now, now + 199);
    bins.set_window(front - 39, front);
    double sum = 0.0;
    int count = 0;
    for (auto it = all.lower_bound(front - 39); it != all.upper_bound(front); ++it) {
      sum += it->second;
      ++count;
    }
    ASSERT_EQ(bins.count(), count) << "step " << now;
    if (count > 0) {
      ASSERT_DOUBLE_EQ(bins.mean_mps(), sum / count) << "step " << now;
    }
  }
}

// What lies in the past or beyond the memory is refused, not bent into it.
TEST(ArrivalBins, RefusesWhatItCannotHold) {
  ArrivalBins bins(50);
  bins.advance(10);
  EXPECT_FALSE(bins.add(9, 1.0));
  EXPECT_TRUE(bins.add(10, 1.0));
  EXPECT_TRUE(bins.add(59, 1.0));
  EXPECT_FALSE(bins.add(60, 1.0));
}

// A sample that arrives is forgotten once its step has passed.
TEST(ArrivalBins, ForgetsWhatHasArrived) {
  ArrivalBins bins(50);
  ASSERT_TRUE(bins.add(5, 3.0));
  bins.set_window(0, 10);
  EXPECT_EQ(bins.count(), 1);
  bins.advance(6);
  bins.set_window(0, 10);
  EXPECT_EQ(bins.count(), 0);
}

}  // namespace
}  // namespace lac
