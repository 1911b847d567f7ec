// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac::sim {
namespace {

constexpr double kLead_s = 2.0;
constexpr double kWindow_s = 1.0;

/// Chain output of 40 rows every 0.5 s: REWS = 10 + t, invalid before 5 s.
Recording chain_output() {
  Recording r({{"LidarRews", "m/s"},
               {"LidarRewsLead", "s"},
               {"LidarRewsValid", "-"},
               {"LidarScanWindow", "s"}},
              0.0, 0.5, 40);
  for (int i = 0; i < 40; ++i) {
    const float row[] = {static_cast<float>(10.0 + 0.5 * i), kLead_s, i >= 10 ? 1.0F : 0.0F,
                         kWindow_s};
    r.append(row);
  }
  return r;
}

Recording time_base() {
  Recording r({{"x", "-"}}, 0.0, 0.1, 300);
  for (int i = 0; i < 300; ++i) {
    const auto value = static_cast<float>(i);
    r.append(&value);
  }
  return r;
}

// A value that came out at t stands for the wind arriving at t + lead - window / 2; between two
// values it is a straight line, and before the first and after the last there is none.
TEST(ReportTest, RewsAtArrival) {
  const auto rews = rews_at_arrival(chain_output(), time_base());
  ASSERT_EQ(rews.size(), 300U);
  for (std::size_t k = 0; k < rews.size(); ++k) {
    const double t_s = 0.1 * static_cast<double>(k);
    if (t_s > 6.5 && t_s < 20.99) {
      ASSERT_NEAR(rews[k], 10.0 + t_s - kLead_s + 0.5 * kWindow_s, 1e-5) << t_s;
    } else if (t_s < 6.49 || t_s > 21.0) {
      ASSERT_TRUE(std::isnan(rews[k])) << t_s;
    }
  }
}

// A file without these channels gives nothing.
TEST(ReportTest, NoLidarChannels) {
  EXPECT_TRUE(rews_at_arrival(time_base(), time_base()).empty());
}

}  // namespace
}  // namespace lac::sim
