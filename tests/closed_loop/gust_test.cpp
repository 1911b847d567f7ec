// SPDX-License-Identifier: Apache-2.0
// Extreme operating gust at 18 m/s with a perfect point preview.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "closed_loop/case_flight.hpp"

namespace lac::test {
namespace {

double overspeed_rpm(const CaseFlight& gust, const Flight& flight) {
  const auto speed_rpm = flight.recording.column("RotSpeed");
  const auto first =
      static_cast<std::ptrdiff_t>(flight.recording.first_row_from(gust.c.time.run_in_s));
  return *std::max_element(speed_rpm.begin() + first, speed_rpm.end()) -
         rpm_from_radps(gust.c.turbine.rated_rotor_speed_radps);
}

// Overspeed at least 60 % smaller than with feedback alone, and nothing to complain of.
TEST(Gust, PreviewTakesTheOverspeedAway) {
  const CaseFlight gust("eog.yaml");
  const Flight lidar = gust.fly(1);
  const double feedback_rpm = overspeed_rpm(gust, gust.fly(0));
  const double lidar_rpm = overspeed_rpm(gust, lidar);
  std::cout << "overspeed: feedback only " << feedback_rpm << " rpm, lidar-assisted " << lidar_rpm
            << " rpm\n";
  EXPECT_GT(feedback_rpm, 1.0);
  EXPECT_LT(lidar_rpm, 0.4 * feedback_rpm);
  EXPECT_TRUE(lidar.warnings.empty()) << lidar.warnings.front().text;
}

}  // namespace
}  // namespace lac::test
