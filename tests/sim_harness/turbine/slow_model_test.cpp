// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/slow_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "sim_harness/turbine/operating_point.hpp"
#include "support/rk4.hpp"

namespace lac::sim {
namespace {

constexpr double kStep_s = 0.0125;

TurbineParams nrel5mw() {
  return load_turbine(LAC_SOURCE_DIR "/config/turbines/nrel5mw/turbine.yaml");
}

/// The turbine without aerodynamics, so that tower and actuators can be seen alone.
TurbineParams without_aerodynamics() {
  TurbineParams params = nrel5mw();
  params.rotor.table = RotorTable({1.0, 20.0}, {0.0, 1.0}, {0, 0, 0, 0}, {0, 0, 0, 0});
  return params;
}

void move_on(const SlowModel& model, const SlowInputs& inputs, SlowState& state) {
  model.pass_demands(inputs, state);
  test::rk4(
      [&](double t, const double* y, double* rates) { model.derivatives(t, inputs, y, rates); },
      kStep_s, 10, state);
}

// A pitch step of 1 deg, below the rate limit, against the closed form of a second-order system.
TEST(SlowModel, PitchStepMatchesClosedForm) {
  const SlowModel model(without_aerodynamics());
  const PitchActuator& actuator = model.params().pitch_actuator;
  const double start_rad = rad_from_deg(5.0);
  const double step_rad = rad_from_deg(1.0);
  const SlowInputs inputs{0.0, 0.0, start_rad + step_rad, 0.0};
  SlowState state{};
  state[kPitch] = start_rad;
  const double z = actuator.damping_ratio;
  const double w = actuator.frequency_radps;
  const double wd = w * std::sqrt(1.0 - z * z);
  for (int k = 1; k <= 240; ++k) {
    move_on(model, inputs, state);
    const double t = kStep_s * k;
    const double envelope = std::exp(-z * w * t);
    const double expected =
        start_rad +
        step_rad * (1.0 - envelope * (std::cos(wd * t) + z * w / wd * std::sin(wd * t)));
    ASSERT_NEAR(state[kPitch], expected, 1e-7 * step_rad) << t;
    ASSERT_NEAR(state[kPitchRate], step_rad * envelope * w * w / wd * std::sin(wd * t),
                1e-6 * step_rad);
  }
}

// A pitch step of 30 deg runs at the rate limit, never faster, and stops without wind-up.
TEST(SlowModel, PitchRateIsLimited) {
  const SlowModel model(without_aerodynamics());
  const double limit_radps = model.params().pitch_actuator.rate_limit_radps;
  const SlowInputs inputs{0.0, 0.0, rad_from_deg(35.0), 0.0};
  SlowState state{};
  state[kPitch] = rad_from_deg(5.0);
  double highest_rad = 0.0;
  for (int k = 1; k <= 800; ++k) {
    const double before_rad = state[kPitch];
    move_on(model, inputs, state);
    ASSERT_LE(state[kPitchRate], limit_radps);
    ASSERT_LE(state[kPitch] - before_rad, limit_radps * kStep_s * (1.0 + 1e-12));
    if (k == 160) {
      EXPECT_NEAR(state[kPitchRate], limit_radps, 1e-6 * limit_radps);
    }
    highest_rad = std::max(highest_rad, state[kPitch]);
  }
  EXPECT_NEAR(state[kPitch], rad_from_deg(35.0), 1e-6);
  // The limit is left at the error e = 2 z rate / w, from where the free response overshoots.
  const double z = model.params().pitch_actuator.damping_ratio;
  const double w = model.params().pitch_actuator.frequency_radps;
  const double wd = w * std::sqrt(1.0 - z * z);
  const double error_rad = 2.0 * z * limit_radps / w;
  double overshoot_rad = 0.0;
  for (double t = 0.0; t < 2.0; t += 1e-3) {
    overshoot_rad =
        std::min(overshoot_rad, std::exp(-z * w * t) *
                                    (error_rad * std::cos(wd * t) +
                                     (z * w * error_rad - limit_radps) / wd * std::sin(wd * t)));
  }
  EXPECT_NEAR(highest_rad - rad_from_deg(35.0), -overshoot_rad, 1e-3 * -overshoot_rad);
}

// At a stop the pitch rests, and leaves it at once when the demand turns.
TEST(SlowModel, PitchRestsAtStops) {
  const SlowModel model(without_aerodynamics());
  SlowState state{};
  state[kPitch] = rad_from_deg(6.0);
  for (int k = 0; k < 400; ++k) {
    move_on(model, {0.0, 0.0, rad_from_deg(-20.0), 0.0}, state);
    ASSERT_GE(state[kPitch], -1e-4);
  }
  SlowState at_rest{};
  for (int k = 0; k < 40; ++k) {
    move_on(model, {0.0, 0.0, rad_from_deg(3.0), 0.0}, state);
    move_on(model, {0.0, 0.0, rad_from_deg(3.0), 0.0}, at_rest);
  }
  EXPECT_NEAR(state[kPitch], at_rest[kPitch], 1e-4);
}

// Generator torque: first-order step, then the rate limit, then the largest torque.
TEST(SlowModel, GeneratorLagAndLimits) {
  TurbineParams params = without_aerodynamics();
  params.generator_lag = {0.5, 15000.0};
  const SlowModel model(params);
  SlowState state{};
  state[kGeneratorTorque] = 30000.0;
  for (int k = 1; k <= 80; ++k) {
    move_on(model, {0.0, 0.0, 0.0, 31000.0}, state);
    const double expected_Nm = 31000.0 - 1000.0 * std::exp(-kStep_s * k / 0.5);
    ASSERT_NEAR(state[kGeneratorTorque], expected_Nm, 1e-3);
  }
  state[kGeneratorTorque] = 10000.0;
  for (int k = 0; k < 80; ++k) move_on(model, {0.0, 0.0, 0.0, 47000.0}, state);
  EXPECT_NEAR(state[kGeneratorTorque], 10000.0 + 15000.0 * 1.0, 1e-6);
  for (int k = 0; k < 1600; ++k) move_on(model, {0.0, 0.0, 0.0, 99000.0}, state);
  EXPECT_NEAR(state[kGeneratorTorque], params.max_torque_Nm, 1e-3);
}

// Without actuator model and lag the states are the demands from the start of the interval on.
TEST(SlowModel, DemandsPassWithoutActuators) {
  TurbineParams params = without_aerodynamics();
  params.pitch_actuator.enabled = false;
  params.generator_lag.time_constant_s = 0.0;
  const SlowModel model(params);
  SlowState state{};
  move_on(model, {0.0, 0.0, 0.2, 40000.0}, state);
  EXPECT_EQ(state[kPitch], 0.2);
  EXPECT_EQ(state[kGeneratorTorque], 40000.0);
  EXPECT_NEAR(state[kRotorSpeed], -97.0 * 40000.0 / params.inertia_kgm2 * kStep_s, 1e-12);
}

// Free decay of the tower: frequency and damping of the file, around the rest offset.
TEST(SlowModel, TowerDecaysWithItsFrequencyAndDamping) {
  const SlowModel model(without_aerodynamics());
  const double offset_m = model.params().tower.rest_offset_m;
  SlowState state{};
  state[kTowerX] = offset_m + 0.5;
  const double w = radps_from_hz(0.324);
  const double d = 0.01;
  const double wd = w * std::sqrt(1.0 - d * d);
  for (int k = 1; k <= 2400; ++k) {
    move_on(model, {0.0, 0.0, 0.0, 0.0}, state);
    const double t = kStep_s * k;
    const double expected_m =
        offset_m + 0.5 * std::exp(-d * w * t) * (std::cos(wd * t) + d * w / wd * std::sin(wd * t));
    ASSERT_NEAR(state[kTowerX], expected_m, 1e-8);
  }
}

// The tower moving up-wind sees more wind: v_rel = v - x'.
TEST(SlowModel, TowerMotionChangesRelativeWind) {
  const SlowModel model(nrel5mw());
  SlowState moving = state_at(model.params(), steady_state(model.params(), 12.0));
  SlowState still = moving;
  moving[kTowerV] = -0.5;
  const SlowInputs inputs{12.0, 0.0, moving[kPitch], moving[kGeneratorTorque]};
  const SlowInputs windier{12.5, 0.0, moving[kPitch], moving[kGeneratorTorque]};
  EXPECT_DOUBLE_EQ(model.outputs(0.0, inputs, moving).thrust_N,
                   model.outputs(0.0, windier, still).thrust_N);
}

// Kinetic energy gained = aerodynamic work - shaft work, through gust and torque changes.
TEST(SlowModel, EnergyBalances) {
  TurbineParams params = nrel5mw();
  params.gearbox_efficiency = 0.955;
  const SlowModel model(params);
  const OperatingPoint point = steady_state(params, 16.0);
  SlowState state = state_at(params, point);
  const double energy_start_J = 0.5 * params.inertia_kgm2 * std::pow(state[kRotorSpeed], 2);
  double work_J = 0.0;
  const auto power_W = [&](const SlowOutputs& out) {
    return (out.aerodynamic_torque_Nm - 97.0 / 0.955 * out.generator_torque_Nm) *
           out.rotor_speed_radps;
  };
  for (int k = 0; k < 4800; ++k) {
    const double t = kStep_s * k;
    const double wind_mps = 16.0 + 2.0 * std::sin(0.5 * t);
    const SlowInputs inputs{wind_mps, std::cos(0.5 * t), point.pitch_rad + 0.01 * std::sin(0.5 * t),
                            point.generator_torque_Nm * (1.0 + 0.05 * std::sin(0.2 * t))};
    const double before_W = power_W(model.outputs(0.0, inputs, state));
    move_on(model, inputs, state);
    work_J += 0.5 * kStep_s * (before_W + power_W(model.outputs(kStep_s, inputs, state)));
  }
  const double energy_J = 0.5 * params.inertia_kgm2 * std::pow(state[kRotorSpeed], 2);
  EXPECT_NEAR(work_J, energy_J - energy_start_J, 1e-4 * energy_J);
  EXPECT_GT(std::abs(energy_J - energy_start_J), 1e-2 * energy_J);
}

// At rest: power, generator speed and the tower-base moment thrust x hub height.
TEST(SlowModel, OutputsInSteadyState) {
  const SlowModel model(nrel5mw());
  const OperatingPoint point = steady_state(model.params(), 18.0);
  const SlowOutputs out =
      model.outputs(0.0, {18.0, 0.0, point.pitch_rad, point.generator_torque_Nm},
                    state_at(model.params(), point));
  EXPECT_NEAR(out.electrical_power_W, 5e6, 1e3);
  EXPECT_NEAR(out.generator_speed_radps, 122.9097, 1e-3);
  EXPECT_NEAR(out.tower_base_moment_Nm, 90.0 * point.thrust_N, 1e-6 * out.tower_base_moment_Nm);
  EXPECT_NEAR(out.tower_a_mps2, 0.0, 1e-9);
}

}  // namespace
}  // namespace lac::sim
