// SPDX-License-Identifier: Apache-2.0
// What a lidar with a real one's weaknesses is worth (config/weak_lidar.yaml), mean of three seeds,
// and that the chain lives with what it loses.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "closed_loop/case_flight.hpp"
#include "sim_harness/run/results.hpp"

namespace lac::test {
namespace {

constexpr int kSeeds = kSanitized ? 1 : 3;

double largest_step_deg(const sim::Recording& r, double from_s) {
  const auto demand_deg = r.column("BldPitchDem");
  double largest = 0.0;
  for (std::size_t i = r.first_row_from(from_s) + 1; i < r.rows(); ++i) {
    largest = std::max(largest, std::abs(demand_deg[i] - demand_deg[i - 1]));
  }
  return largest;
}

// Standard deviation of the rotor speed at least 25 % smaller than that of feedback alone, larger
// than with a lidar that sees perfectly from the same place. Losing the lidar and finding it again
// never moves the pitch demand by more than 0.05 deg in a step, and all that is said is that the
// wind speed is lost, a few times in eleven minutes.
TEST(WeakLidar, AgainstFeedbackOnlyAndAPerfectOne) {
  double feedback_rpm = 0.0, perfect_rpm = 0.0, weak_rpm = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    CaseFlight flight("weak_lidar.yaml", {"seed=" + std::to_string(seed)});
    const double run_in_s = flight.c.time.run_in_s;
    const auto std_rpm = [&](const sim::Recording& r) {
      return sim::flight_figures(r, run_in_s).rotor_speed_std_rpm / kSeeds;
    };
    feedback_rpm += std_rpm(flight.fly(0).recording);
    const Flight weak = flight.fly(1);
    weak_rpm += std_rpm(weak.recording);
    EXPECT_LT(largest_step_deg(weak.recording, run_in_s), 0.05);
    EXPECT_LT(weak.warnings.size(), 10U);
    for (const Warning& w : weak.warnings) {
      EXPECT_NE(w.text.find("no valid lidar wind speed"), std::string::npos) << w.text;
    }
    flight.c.lidar->weaknesses = {};
    const Flight perfect = flight.fly(1);
    perfect_rpm += std_rpm(perfect.recording);
    EXPECT_TRUE(perfect.warnings.empty());
  }
  std::cout << "rotor speed std: feedback only " << feedback_rpm << ", weak lidar " << weak_rpm
            << ", perfect lidar " << perfect_rpm << " rpm\n";
  EXPECT_LT(weak_rpm, 0.75 * feedback_rpm);
  EXPECT_GT(weak_rpm, 1.02 * perfect_rpm);
}

}  // namespace
}  // namespace lac::test
