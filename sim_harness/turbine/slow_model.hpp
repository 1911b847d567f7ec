// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "sim_harness/turbine/turbine_params.hpp"

namespace lac::sim {

/// What acts on the turbine during one controller interval: demands held, wind linear in time.
/// The time counts from the start of the interval.
struct SlowInputs {
  double wind_mps;  // rotor-effective wind at time 0
  double wind_slope_mps2;
  double pitch_demand_rad;
  double torque_demand_Nm;  // generator side

  double wind_at(double time_s) const noexcept { return wind_mps + wind_slope_mps2 * time_s; }
};

/// Places of the states in a state array.
enum SlowStateIndex : std::size_t {
  kRotorSpeed,       // rad/s, low-speed shaft
  kTowerX,           // m, tower top fore-aft, down-wind positive
  kTowerV,           // m/s
  kPitch,            // rad, collective
  kPitchRate,        // rad/s
  kGeneratorTorque,  // N m
  kSlowStateCount
};
using SlowState = std::array<double, kSlowStateCount>;

struct SlowOutputs {
  double rotor_speed_radps;
  double generator_speed_radps;
  double pitch_rad;
  double pitch_rate_radps;
  double generator_torque_Nm;
  double electrical_power_W;
  double aerodynamic_torque_Nm;
  double thrust_N;
  double tower_x_m;
  double tower_v_mps;
  double tower_a_mps2;
  double tower_base_moment_Nm;  // M_yT = h_hub (k (x - x_T0) + c x')
};

/// SLOW, a turbine with rotor speed and tower fore-aft motion (methods section 11), with pitch
/// actuator and generator lag. A right-hand side: it knows no solver, no file and holds no state.
///
///     J Omega' = M_a - i M_g / eta_gearbox
///     m x'' + c x' + k (x - x_T0) = F_a,        v_rel = v - x'
///     theta'' = 2 z w (r - theta'),             r = sat(w / (2 z) (theta_c - theta), rate limit)
///     M_g' = sat((M_c - M_g) / tau, rate limit)
///     P_el = eta M_g i Omega
///
/// Below the rate limit the third line is theta'' + 2 z w theta' + w^2 theta = w^2 theta_c; at the
/// limit the rate approaches it with time constant 1 / (2 z w) and never winds up. The pitch
/// rests at its stops; demands beyond them, below 0 or above the largest torque count as the limit.
class SlowModel {
 public:
  explicit SlowModel(const TurbineParams& params);

  void derivatives(double time_s, const SlowInputs& inputs, const double* state,
                   double* rates) const noexcept;

  /// Sets the states that follow their demand without dynamics (actuator off, no generator lag).
  /// To be called at the start of each interval.
  void pass_demands(const SlowInputs& inputs, SlowState& state) const noexcept;

  SlowOutputs outputs(double time_s, const SlowInputs& inputs,
                      const SlowState& state) const noexcept;

  const TurbineParams& params() const noexcept { return params_; }

 private:
  double limited_pitch(double demand_rad) const noexcept;
  double limited_torque(double demand_Nm) const noexcept;
  RotorAero::Loads loads(double time_s, const SlowInputs& inputs,
                         const double* state) const noexcept;
  double tower_force_N(const double* state) const noexcept;  // k (x - x_T0) + c x'
  void pitch_rates(double demand_rad, const double* state, double* rates) const noexcept;
  double torque_rate_Nmps(double demand_Nm, double torque_Nm) const noexcept;

  TurbineParams params_;
};

}  // namespace lac::sim
