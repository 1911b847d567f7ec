// SPDX-License-Identifier: Apache-2.0
// The controller with the rotor as one degree of freedom.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "feedback/feedback.hpp"
#include "feedback/nrel5mw.hpp"

namespace lac {
namespace {

constexpr double kTimeStep_s = 0.0125;

struct Loop {
  Loop(const FeedbackParams& params, double rotor_speed_radps, double start_pitch_rad)
      : feedback(params, kTimeStep_s), rotor{test::nrel5mw_plant(), rotor_speed_radps} {
    out.pitch_rad = start_pitch_rad;
  }
  void step(double wind_mps) {
    const Feedback::Inputs in{rotor.generator_speed_radps(), out.pitch_rad, out.torque_Nm};
    out = feedback.step(in, state, events);
    rotor.advance(wind_mps, out.pitch_rad, out.torque_Nm, kTimeStep_s);
  }
  void run(double wind_mps, double duration_s) {
    for (int i = 0; i < static_cast<int>(duration_s / kTimeStep_s); ++i) step(wind_mps);
  }
  double rotor_rpm() const { return rpm_from_radps(rotor.speed_radps); }
  double electrical_kW() const {
    return 1e-3 * 0.944 * out.torque_Nm * rotor.generator_speed_radps();
  }
  Feedback feedback;
  Feedback::State state;
  Feedback::Events events;
  Feedback::Outputs out;
  test::OneDofRotor rotor;
};

struct Steady {
  double wind_mps;
  double rotor_rpm;
  double pitch_deg;
  double power_kW;
};
constexpr Steady kReport[] = {{8.0, 9.2, 0.0, 1780.0},
                              {11.4, 12.1, 0.0, 5000.0},
                              {14.0, 12.1, 8.70, 5000.0},
                              {18.0, 12.1, 14.92, 5000.0},
                              {24.0, 12.1, 22.35, 5000.0}};

// Steady states from a start away from them: rotor speed within 1 %, pitch within 0.7 deg, power
// within 4 % up to rated and 1 % above of the NREL report.
TEST(ClosedLoop, ReachesTheSteadyStatesOfTheReport) {
  for (const Steady& s : kReport) {
    Loop loop(test::shipped_params(), radps_from_rpm(0.95 * s.rotor_rpm), 0.0);
    loop.run(s.wind_mps, 600.0);
    EXPECT_NEAR(loop.rotor_rpm(), s.rotor_rpm, 0.01 * s.rotor_rpm) << s.wind_mps;
    EXPECT_NEAR(deg_from_rad(loop.out.pitch_rad), s.pitch_deg, 0.7) << s.wind_mps;
    EXPECT_NEAR(loop.electrical_kW(), s.power_kW, (s.wind_mps < 12.0 ? 0.04 : 0.01) * s.power_kW)
        << s.wind_mps;
  }
}

// Above rated in region 3 the speed is on its set point exactly, constant power or torque.
TEST(ClosedLoop, HoldsRatedSpeedWithEitherTorqueLaw) {
  for (const char* law : {"power", "torque"}) {
    Loop loop(
        test::parsed(test::shipped_text("AboveRated", std::string(law) + " ! AboveRated - x")),
        radps_from_rpm(12.1), 0.2);
    loop.run(16.0, 300.0);
    EXPECT_NEAR(loop.rotor_rpm(), 12.1, 1e-4) << law;
    EXPECT_EQ(loop.out.region, TorqueRegion::Rated) << law;
    EXPECT_NEAR(loop.out.torque_Nm, 43093.55, 1.0) << law;
  }
}

// A small push decays as the poles that were asked for:
// x = x0 e^{-z w t} (cos w_d t - z w/w_d sin w_d t). Filters out of the way; 5 % of the push for
// the kinks of the table.
TEST(ClosedLoop, DecaysAsDesigned) {
  FeedbackParams p = test::shipped_params();
  p.speed.low_pass_hz = 20.0;
  p.speed.notch_bandwidth_hz = 0.0;
  for (const double wind : {16.0, 20.0}) {
    const double pitch = point_above_rated(test::nrel5mw_plant(), wind).pitch_rad;
    Loop loop(p, radps_from_rpm(12.1), pitch);
    loop.run(wind, 200.0);
    const double rest = loop.rotor.speed_radps;
    const double push = 0.01 * rest;
    loop.rotor.speed_radps += push;
    const double w = 0.5;
    const double z = 0.7;
    const double w_d = w * std::sqrt(1.0 - z * z);
    for (int i = 1; i <= 80 * 15; ++i) {
      loop.step(wind);
      const double t = i * kTimeStep_s;
      const double expected =
          push * std::exp(-z * w * t) * (std::cos(w_d * t) - z * w / w_d * std::sin(w_d * t));
      ASSERT_NEAR(loop.rotor.speed_radps - rest, expected, 0.05 * push) << wind << " m/s, " << t;
    }
  }
}

// Through rated and back on a slow ramp: the loops hand over without a fight. The speed stays
// within 3 % of rated above it, the blades are at fine pitch while torque control works, and the
// run ends where it began.
TEST(ClosedLoop, CrossesRatedWithoutAFight) {
  Loop loop(test::shipped_params(), radps_from_rpm(9.2), 0.0);
  loop.run(8.0, 200.0);
  const double torque_before = loop.out.torque_Nm;
  double fastest = 0.0;
  double largest_pitch_short_of_power = 0.0;
  for (int i = 0; i < 80 * 600; ++i) {
    const double t = i * kTimeStep_s;
    const double wind = 8.0 + 8.0 * (1.0 - std::abs(t - 300.0) / 300.0);
    loop.step(wind);
    fastest = std::max(fastest, loop.rotor_rpm());
    if (wind < 11.0) {
      largest_pitch_short_of_power = std::max(largest_pitch_short_of_power, loop.out.pitch_rad);
    }
  }
  EXPECT_LT(fastest, 1.03 * 12.1);
  EXPECT_EQ(largest_pitch_short_of_power, 0.0);
  loop.run(8.0, 200.0);
  EXPECT_NEAR(loop.out.torque_Nm, torque_before, 1.0);
  EXPECT_EQ(loop.out.region, TorqueRegion::Optimal);
}

// Derated, the speed stays at rated and the blades give the power away.
TEST(ClosedLoop, DeratesAtRatedSpeed) {
  Loop loop(test::shipped_params(), radps_from_rpm(12.1), 0.2);
  loop.run(16.0, 100.0);
  const double full_pitch = loop.out.pitch_rad;
  for (int i = 0; i < 80 * 300; ++i) {
    Feedback::Inputs in{loop.rotor.generator_speed_radps(), loop.out.pitch_rad, 0.0};
    in.power_level = 0.6;
    loop.out = loop.feedback.step(in, loop.state, loop.events);
    loop.rotor.advance(16.0, loop.out.pitch_rad, loop.out.torque_Nm, kTimeStep_s);
  }
  EXPECT_NEAR(loop.electrical_kW(), 3000.0, 1.0);
  EXPECT_NEAR(loop.rotor_rpm(), 12.1, 1e-3);
  EXPECT_GT(loop.out.pitch_rad, full_pitch);
}

}  // namespace
}  // namespace lac
