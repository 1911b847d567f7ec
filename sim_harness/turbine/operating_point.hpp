// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_harness/turbine/slow_model.hpp"

namespace lac::sim {

/// A steady state of the turbine in steady wind.
struct OperatingPoint {
  double wind_mps;
  double rotor_speed_radps;
  double pitch_rad;
  double generator_torque_Nm;
  double electrical_power_W;
  double thrust_N;
};

/// Solves M_a = i M_g / eta_gearbox on the constraint of the operating region: M_g = k Omega_g^2
/// at fine pitch; where that would exceed rated speed, rated speed at fine pitch; where that would
/// exceed rated torque, rated speed and torque with the pitch that balances them.
/// Throws Error when there is none: no wind, or more wind than the rotor table can shed.
OperatingPoint steady_state(const TurbineParams& params, double wind_mps);

/// The state at rest in this operating point, the tower bent by the thrust.
SlowState state_at(const TurbineParams& params, const OperatingPoint& point);

}  // namespace lac::sim
