// SPDX-License-Identifier: Apache-2.0
// An unmodified ROSCO as feedback secondary behind our master, flying NREL 5 MW in the harness.
#include <gtest/gtest.h>

#include <iostream>
#include <numeric>

#include "closed_loop/case_flight.hpp"
#include "rosco/rosco_files.hpp"

namespace lac::test {
namespace {

class RoscoSecondary : public testing::Test {
 protected:
  void SetUp() override {
    if (!rosco.there()) {
      GTEST_SKIP() << rosco.library << " is not there: the rosco wheel was not downloaded";
    }
    direct_.name = "direct";
    direct_.input_file = rosco.copy_input_to(folder);
    direct_.library = rosco.library.string();
    secondary_.name = "secondary";
    secondary_.input_file =
        folder.write("wrapper.IN", "rosco \"" + rosco.library.string() +
                                       "\" DISCON.IN ! Secondary_1 - unmodified\n"
                                       "none ! LidarLayout - no lidar\n");
  }

  CaseFlight steady() const {
    return CaseFlight("steady.yaml",
                      {"wind.speed_mps=14", "time.run_in_s=60", "time.duration_s=100"});
  }
  CaseFlight turbulent() const {
    return CaseFlight("demo.yaml",
                      {"wind.mean_speed_mps=14", "wind.period_s=100", "time.duration_s=100"});
  }

  /// Speeds, pitch, torque, loads and demands of all steps: the loop is closed, so equal demands
  /// at each step mean equal inputs at the next.
  static void expect_same_bits(const sim::Recording& a, const sim::Recording& b) {
    ASSERT_EQ(a.rows(), b.rows());
    for (const TableChannel& channel : a.channels()) {
      EXPECT_EQ(a.column(channel.name), b.column(channel.name)) << channel.name;
    }
  }

  TempFolder folder;
  RoscoFiles rosco;
  sim::CaseController direct_, secondary_;
};

double mean_of(const sim::Recording& r, const char* channel, double from_s) {
  const auto values = r.column(channel);
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(r.first_row_from(from_s));
  return std::accumulate(first, values.end(), 0.0) / static_cast<double>(values.end() - first);
}

// Steady wind: it holds rated speed, says nothing, ends well; the demands are those it gives when
// the host calls it itself.
TEST_F(RoscoSecondary, SteadyWind) {
  const CaseFlight flight = steady();
  const Flight behind_master = flight.fly(secondary_);
  const sim::Recording& r = behind_master.recording;
  EXPECT_TRUE(behind_master.warnings.empty()) << behind_master.warnings.front().text;
  std::cout << "mean rotor speed " << mean_of(r, "RotSpeed", 60.0) << " rpm, mean power "
            << mean_of(r, "GenPwr", 60.0) << " kW\n";
  EXPECT_NEAR(mean_of(r, "RotSpeed", 60.0), 12.1, 0.121);
  expect_same_bits(r, flight.fly(direct_).recording);
}

// The same in turbulence.
TEST_F(RoscoSecondary, Turbulence) {
  const CaseFlight flight = turbulent();
  const Flight behind_master = flight.fly(secondary_);
  EXPECT_TRUE(behind_master.warnings.empty()) << behind_master.warnings.front().text;
  const auto speed_rpm = behind_master.recording.column("RotSpeed");
  for (const double rpm : speed_rpm) ASSERT_NEAR(rpm, 12.1, 3.0);
  expect_same_bits(behind_master.recording, flight.fly(direct_).recording);
}

// One run after the other in one process: nothing of the first is left in the second.
TEST_F(RoscoSecondary, TwoRuns) {
  const CaseFlight flight = turbulent();
  const Flight first = flight.fly(secondary_);
  steady().fly(secondary_);
  expect_same_bits(first.recording, flight.fly(secondary_).recording);
}

}  // namespace
}  // namespace lac::test
