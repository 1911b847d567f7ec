// SPDX-License-Identifier: Apache-2.0
// What the lidar is worth: the demo case, mean of six seeds.
#include <gtest/gtest.h>

#include <iostream>

#include "closed_loop/case_flight.hpp"
#include "sim_harness/run/results.hpp"

namespace lac::test {
namespace {

constexpr int kSeeds = kSanitized ? 1 : 6;

struct Means {
  double rotor_speed_std_rpm = 0.0, tower_del_MNm = 0.0, power_kW = 0.0;

  void add(const sim::FlightFigures& f) {
    rotor_speed_std_rpm += f.rotor_speed_std_rpm / kSeeds;
    tower_del_MNm += f.tower_base_del_MNm / kSeeds;
    power_kW += f.power_mean_kW / kSeeds;
  }
  void print(const char* name) const {
    std::cout << name << ": rotor speed std " << rotor_speed_std_rpm << " rpm, tower DEL "
              << tower_del_MNm << " MNm, mean power " << power_kW << " kW\n";
  }
};

// Standard deviation of the rotor speed at least 25 % smaller, tower DEL smaller, mean power
// within 0.5 %; no warning in any run.
TEST(DemoSeeds, LidarAssistedAgainstFeedbackOnly) {
  Means feedback, lidar;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const CaseFlight demo("demo.yaml", {"seed=" + std::to_string(seed)});
    const double run_in_s = demo.c.time.run_in_s;
    feedback.add(sim::flight_figures(demo.fly(0).recording, run_in_s));
    const Flight assisted = demo.fly(1);
    lidar.add(sim::flight_figures(assisted.recording, run_in_s));
    for (const Warning& w : assisted.warnings) {
      ADD_FAILURE() << "seed " << seed << ", " << w.time_s << " s: " << w.text;
    }
  }
  feedback.print("feedback only ");
  lidar.print("lidar-assisted");
  EXPECT_LT(lidar.rotor_speed_std_rpm, 0.75 * feedback.rotor_speed_std_rpm);
  EXPECT_LT(lidar.tower_del_MNm, feedback.tower_del_MNm);
  EXPECT_NEAR(lidar.power_kW, feedback.power_kW, 0.005 * feedback.power_kW);
}

}  // namespace
}  // namespace lac::test
