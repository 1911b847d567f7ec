// SPDX-License-Identifier: Apache-2.0
// A lidar that dies or lies in the middle of a run: the lidar-assisted chain falls back to what
// feedback alone does, without a step in the pitch demand, and says so once.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

#include "closed_loop/case_flight.hpp"

namespace lac::test {
namespace {

using sim::LidarFaultKind;

constexpr double kFault_s = 300.0;
constexpr double kFaded_s = 400.0;
constexpr double kEnd_s = kSanitized ? 410.0 : 500.0;

CaseFlight& demo() {
  static CaseFlight flight("demo.yaml", {"time.duration_s=" + std::to_string(kEnd_s)});
  return flight;
}
Flight fly_with(LidarFaultKind kind) {
  demo().c.lidar->fault = {.kind = kind, .start_s = kFault_s};
  return demo().fly(1);
}

/// Each run is flown once for all tests.
const Flight& feedback_only() {
  static const Flight flight = demo().fly(0);
  return flight;
}
const Flight& with_fault(LidarFaultKind kind) {
  static std::map<LidarFaultKind, Flight> flights;
  const auto known = flights.find(kind);
  return known != flights.end() ? known->second
                                : flights.emplace(kind, fly_with(kind)).first->second;
}
const Flight& undisturbed() {
  return with_fault(LidarFaultKind::kNone);
}

/// Largest change of the pitch demand from one controller step to the next, in deg.
double largest_step_deg(const sim::Recording& r, double from_s, double to_s) {
  const auto demand_deg = r.column("BldPitchDem");
  double largest = 0.0;
  for (std::size_t i = r.first_row_from(from_s); i < r.first_row_from(to_s); ++i) {
    largest = std::max(largest, std::abs(demand_deg[i] - demand_deg[i - 1]));
  }
  return largest;
}

class LidarFaults : public testing::TestWithParam<LidarFaultKind> {};

// Up to the fault the run is the undisturbed one to the last bit. 100 s later it is the one
// of feedback alone: what is left of the state at the fault has decayed (slowest time constant
// about 4 s) below the rounding of the single precision demands, which 1e-4 rpm leaves room for.
TEST_P(LidarFaults, EndsAsFeedbackOnly) {
  const Flight& flight = with_fault(GetParam());
  const sim::Recording& r = flight.recording;
  const std::size_t fault = r.first_row_from(kFault_s), last = r.rows();
  const std::size_t faded = r.first_row_from(kFaded_s);
  EXPECT_EQ(largest_difference(r, undisturbed().recording, "RotSpeed", 0, fault), 0.0);
  EXPECT_GT(largest_difference(r, feedback_only().recording, "RotSpeed", 0, fault), 0.1);
  const double left_rpm = largest_difference(r, feedback_only().recording, "RotSpeed", faded, last);
  const double left_deg =
      largest_difference(r, feedback_only().recording, "BldPitchDem", faded, last);
  std::cout << "left of the difference: " << left_rpm << " rpm, " << left_deg << " deg\n";
  EXPECT_LT(left_rpm, 1e-4);
  EXPECT_LT(left_deg, 1e-3);
}

// While it is found out and faded the pitch demand moves no faster than 0.05 deg per controller
// step; the same chain without the fault gives the scale.
TEST_P(LidarFaults, NoStepInThePitchDemand) {
  const Flight& flight = with_fault(GetParam());
  const double step_deg = largest_step_deg(flight.recording, kFault_s, kFault_s + 20.0);
  std::cout << "largest step of the pitch demand: " << step_deg << " deg, without the fault "
            << largest_step_deg(undisturbed().recording, kFault_s, kFault_s + 20.0) << " deg\n";
  EXPECT_LT(step_deg, 0.05);
}

// It is said within 5 s, and nothing is said twice. (The turbulence estimate lives on for half its
// averaging time; its end is told then.)
TEST_P(LidarFaults, ToldOnce) {
  std::set<std::string> texts;
  double first_s = kEnd_s;
  for (const Warning& w : with_fault(GetParam()).warnings) {
    if (w.time_s < kFault_s) continue;
    std::cout << w.time_s << " s: " << w.text << '\n';
    EXPECT_TRUE(texts.insert(w.text).second) << w.text;
    first_s = std::min(first_s, w.time_s);
  }
  EXPECT_LT(first_s, kFault_s + 5.0);
  for (const Warning& w : undisturbed().warnings) EXPECT_LT(w.time_s, kFault_s) << w.text;
}

INSTANTIATE_TEST_SUITE_P(Kinds, LidarFaults,
                         testing::Values(LidarFaultKind::kDead, LidarFaultKind::kNotANumber,
                                         LidarFaultKind::kStuck, LidarFaultKind::kFrozen,
                                         LidarFaultKind::kOutOfRange));

}  // namespace
}  // namespace lac::test
