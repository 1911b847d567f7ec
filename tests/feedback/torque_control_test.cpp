// SPDX-License-Identifier: Apache-2.0
#include "feedback/torque_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "feedback/nrel5mw.hpp"

namespace lac {
namespace {

constexpr double kTimeStep_s = 0.0125;

TorqueControl::Params params() {
  return test::shipped_params().torque;
}

/// Torque after a long time at constant speed.
TorqueControl::Output settled(const TorqueControl::Params& p, double speed_radps,
                              double shift_radps = 0.0, double power_level = 1.0) {
  const TorqueControl control(p, kTimeStep_s);
  TorqueControl::State state;
  control.start(speed_radps, power_level, 0.0, state);
  TorqueControl::Output out;
  for (int i = 0; i < 80 * 60; ++i) {
    out = control.step(speed_radps, shift_radps, power_level, state);
  }
  return out;
}

// The law at points of each region.
TEST(TorqueControl, FollowsTheRegions) {
  const TorqueControl::Params p = params();
  EXPECT_EQ(settled(p, radps_from_rpm(600.0)).torque_Nm, 0.0);
  EXPECT_EQ(settled(p, radps_from_rpm(600.0)).region, TorqueRegion::Off);
  for (const double rpm : {800.0, 900.0, 1100.0}) {
    const double speed = radps_from_rpm(rpm);
    EXPECT_NEAR(settled(p, speed).torque_Nm, 2.3323 * speed * speed, 1e-6) << rpm;
    EXPECT_EQ(settled(p, speed).region, TorqueRegion::Optimal) << rpm;
  }
  const double fast = radps_from_rpm(1200.0);
  EXPECT_NEAR(settled(p, fast).torque_Nm, 43093.55 * 1173.7 / 1200.0, 1e-6);
  EXPECT_EQ(settled(p, fast).region, TorqueRegion::Rated);
}

// Between its limits the torque is the PI law around the rated speed or around the low one.
TEST(TorqueControl, HoldsTheSetPointsByPi) {
  const TorqueControl::Params p = params();
  const TorqueControl control(p, kTimeStep_s);
  for (const double set_point : {p.rated_speed_radps, p.low_speed_radps}) {
    const double start = set_point == p.rated_speed_radps ? 39000.0 : 6000.0;
    TorqueControl::State state;
    control.start(set_point, 1.0, start, state);
    double integral = 0.0;
    for (int i = 0; i < 40; ++i) {
      const double error = 0.3 * std::sin(0.1 * i);
      integral += kTimeStep_s / p.gains.integral_time_s * error;
      const auto out = control.step(set_point + error, 0.0, 1.0, state);
      ASSERT_NEAR(out.torque_Nm, start + p.gains.proportional * (error + integral), 1e-6);
      ASSERT_EQ(out.region,
                set_point == p.rated_speed_radps ? TorqueRegion::HeldRated : TorqueRegion::HeldLow);
    }
  }
}

// Over a slow run-up through all regions the torque does not step: each of its changes is within
// what the slope of the steady law and the PI gain allow.
TEST(TorqueControl, IsContinuousThroughTheRegions) {
  const TorqueControl::Params p = params();
  const TorqueControl control(p, kTimeStep_s);
  for (const double direction : {1.0, -1.0}) {
    const double from = radps_from_rpm(direction > 0.0 ? 600.0 : 1250.0);
    const double slope = direction * radps_from_rpm(650.0) / (80.0 * 600.0);
    TorqueControl::State state;
    double last = control.start(from, 1.0, 0.0, state).torque_Nm;
    if (direction < 0.0) last = control.start(from, 1.0, 43000.0, state).torque_Nm;
    for (int i = 1; i <= 80 * 600; ++i) {
      const double torque = control.step(from + slope * i, 0.0, 1.0, state).torque_Nm;
      // 15 kNm/s would be 187 Nm per step; the PI with 50 rad/s from its set point 15 Nm.
      ASSERT_LT(std::abs(torque - last), 30.0) << "at " << rpm_from_radps(from + slope * i);
      last = torque;
    }
    EXPECT_NEAR(last, direction > 0.0 ? 43093.55 * 1173.7 / 1250.0 : 0.0, 1.0);
  }
}

// Constant torque above rated, and the limit on the torque itself.
TEST(TorqueControl, ConstantTorqueAndLargestTorque) {
  TorqueControl::Params p = params();
  EXPECT_NEAR(settled(p, p.rated_speed_radps, 12.0, 1.2).torque_Nm, p.max_torque_Nm, 1e-6);
  p.above_rated = TorqueControl::AboveRated::ConstantTorque;
  EXPECT_NEAR(settled(p, radps_from_rpm(1250.0)).torque_Nm, 43093.55, 1e-6);
  EXPECT_NEAR(settled(p, radps_from_rpm(1190.0)).torque_Nm, 43093.55, 1e-6);
}

// Power level: the torque of g times rated power at rated speed, and k Omega^2 below it gives way.
TEST(TorqueControl, PowerLevelScalesTheUpperLimit) {
  const TorqueControl::Params p = params();
  EXPECT_NEAR(
      settled(p, p.rated_speed_radps + 1.0, 0.0, 0.9).torque_Nm * (p.rated_speed_radps + 1.0),
      0.9 * 43093.55 * p.rated_speed_radps, 1.0);
  const auto deep = settled(p, radps_from_rpm(1150.0), 0.0, 0.5);
  EXPECT_NEAR(deep.torque_Nm, 0.5 * 43093.55 * 1173.7 / 1150.0, 1e-6);
  EXPECT_EQ(deep.region, TorqueRegion::Rated);
  EXPECT_EQ(settled(p, radps_from_rpm(1150.0), 0.0, 0.0).torque_Nm, 0.0);
}

// A positive shift lowers the reference: below rated speed the torque goes to its upper limit.
TEST(TorqueControl, ShiftPutsItOnTheUpperLimit) {
  const TorqueControl::Params p = params();
  const double speed = p.rated_speed_radps - 2.0;
  EXPECT_EQ(settled(p, speed, 0.0).region, TorqueRegion::Optimal);
  EXPECT_EQ(settled(p, speed, 4.0).region, TorqueRegion::Rated);
  EXPECT_EQ(settled(p, speed, -4.0).region, TorqueRegion::Optimal);
}

// The torque moves no faster than its rate.
TEST(TorqueControl, RespectsTheRate) {
  const TorqueControl control(params(), kTimeStep_s);
  TorqueControl::State state;
  double last = control.start(radps_from_rpm(1100.0), 1.0, 0.0, state).torque_Nm;
  double largest = 0.0;
  for (int i = 0; i < 80; ++i) {
    const double torque = control.step(radps_from_rpm(1300.0), 12.0, 1.0, state).torque_Nm;
    largest = std::max(largest, std::abs(torque - last));
    last = torque;
  }
  EXPECT_NEAR(largest, 15000.0 * kTimeStep_s, 1e-9);
}

// Records carry the usual numbers.
TEST(TorqueControl, NumbersTheRegions) {
  EXPECT_EQ(region_number(TorqueRegion::Off), 1.0);
  EXPECT_EQ(region_number(TorqueRegion::HeldLow), 1.5);
  EXPECT_EQ(region_number(TorqueRegion::Optimal), 2.0);
  EXPECT_EQ(region_number(TorqueRegion::HeldRated), 2.5);
  EXPECT_EQ(region_number(TorqueRegion::Rated), 3.0);
}

}  // namespace
}  // namespace lac
