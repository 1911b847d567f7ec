// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/slow_model.hpp"

#include <algorithm>

namespace lac::sim {

SlowModel::SlowModel(const TurbineParams& params) : params_(params) {}

double SlowModel::limited_pitch(double demand_rad) const noexcept {
  return std::clamp(demand_rad, params_.min_pitch_rad, params_.max_pitch_rad);
}

double SlowModel::limited_torque(double demand_Nm) const noexcept {
  return std::clamp(demand_Nm, 0.0, params_.max_torque_Nm);
}

void SlowModel::pass_demands(const SlowInputs& inputs, SlowState& state) const noexcept {
  if (!params_.pitch_actuator.enabled) {
    state[kPitch] = limited_pitch(inputs.pitch_demand_rad);
    state[kPitchRate] = 0.0;
  }
  if (params_.generator_lag.time_constant_s == 0.0) {
    state[kGeneratorTorque] = limited_torque(inputs.torque_demand_Nm);
  }
}

RotorAero::Loads SlowModel::loads(double time_s, const SlowInputs& inputs,
                                  const double* state) const noexcept {
  return params_.rotor.loads(inputs.wind_at(time_s) - state[kTowerV], state[kRotorSpeed],
                             state[kPitch]);
}

double SlowModel::tower_force_N(const double* state) const noexcept {
  const TowerMode& tower = params_.tower;
  return tower.stiffness_Npm * (state[kTowerX] - tower.rest_offset_m) +
         tower.damping_Nspm * state[kTowerV];
}

void SlowModel::pitch_rates(double demand_rad, const double* state, double* rates) const noexcept {
  const PitchActuator& actuator = params_.pitch_actuator;
  const double two_zw = 2.0 * actuator.damping_ratio * actuator.frequency_radps;
  const double error_rad = limited_pitch(demand_rad) - state[kPitch];
  const double wanted_rate_radps =
      std::clamp(actuator.frequency_radps * actuator.frequency_radps / two_zw * error_rad,
                 -actuator.rate_limit_radps, actuator.rate_limit_radps);
  const double rate_radps = state[kPitchRate];
  const bool at_stop = (state[kPitch] <= params_.min_pitch_rad && rate_radps < 0.0) ||
                       (state[kPitch] >= params_.max_pitch_rad && rate_radps > 0.0);
  rates[kPitch] = at_stop ? 0.0 : rate_radps;
  rates[kPitchRate] = two_zw * (wanted_rate_radps - rate_radps);
}

double SlowModel::torque_rate_Nmps(double demand_Nm, double torque_Nm) const noexcept {
  const GeneratorLag& lag = params_.generator_lag;
  return std::clamp((limited_torque(demand_Nm) - torque_Nm) / lag.time_constant_s,
                    -lag.torque_rate_limit_Nmps, lag.torque_rate_limit_Nmps);
}

void SlowModel::derivatives(double time_s, const SlowInputs& inputs, const double* state,
                            double* rates) const noexcept {
  const RotorAero::Loads aero = loads(time_s, inputs, state);
  const double shaft_torque_Nm =
      params_.gearbox_ratio / params_.gearbox_efficiency * state[kGeneratorTorque];
  rates[kRotorSpeed] = (aero.torque_Nm - shaft_torque_Nm) / params_.inertia_kgm2;
  rates[kTowerX] = state[kTowerV];
  rates[kTowerV] = (aero.thrust_N - tower_force_N(state)) / params_.tower.mass_kg;
  if (params_.pitch_actuator.enabled) {
    pitch_rates(inputs.pitch_demand_rad, state, rates);
  } else {
    rates[kPitch] = rates[kPitchRate] = 0.0;
  }
  rates[kGeneratorTorque] = params_.generator_lag.time_constant_s > 0.0
                                ? torque_rate_Nmps(inputs.torque_demand_Nm, state[kGeneratorTorque])
                                : 0.0;
}

SlowOutputs SlowModel::outputs(double time_s, const SlowInputs& inputs,
                               const SlowState& state) const noexcept {
  const RotorAero::Loads aero = loads(time_s, inputs, state.data());
  const double tower_force = tower_force_N(state.data());
  const double generator_speed_radps = params_.gearbox_ratio * state[kRotorSpeed];
  return {.rotor_speed_radps = state[kRotorSpeed],
          .generator_speed_radps = generator_speed_radps,
          .pitch_rad = state[kPitch],
          .pitch_rate_radps = state[kPitchRate],
          .generator_torque_Nm = state[kGeneratorTorque],
          .electrical_power_W =
              params_.generator_efficiency * state[kGeneratorTorque] * generator_speed_radps,
          .aerodynamic_torque_Nm = aero.torque_Nm,
          .thrust_N = aero.thrust_N,
          .tower_x_m = state[kTowerX],
          .tower_v_mps = state[kTowerV],
          .tower_a_mps2 = (aero.thrust_N - tower_force) / params_.tower.mass_kg,
          .tower_base_moment_Nm = params_.hub_height_m * tower_force};
}

}  // namespace lac::sim
