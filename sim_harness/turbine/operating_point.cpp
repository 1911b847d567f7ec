// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/operating_point.hpp"

#include <algorithm>
#include <string>

#include "core/error.hpp"

namespace lac::sim {

namespace {

/// Where `excess` turns from positive at `low` to negative at `high`, to the last digits.
template <typename Function>
double falling_root(Function excess, double low, double high) {
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double rated_shaft_torque_Nm(const TurbineParams& p) {
  return p.rated_torque_Nm * p.gearbox_ratio / p.gearbox_efficiency;
}

/// Rotor speed where the region-2 law, capped at rated torque, balances the rotor at fine pitch.
double tracking_speed_radps(const TurbineParams& p, double wind_mps) {
  const double ratio_cubed = p.gearbox_ratio * p.gearbox_ratio * p.gearbox_ratio;
  const double gain = p.region2_gain_Nms2prad2 * ratio_cubed / p.gearbox_efficiency;
  const auto excess_Nm = [&](double speed_radps) {
    return p.rotor.torque_Nm(wind_mps, speed_radps, p.fine_pitch_rad) -
           std::min(gain * speed_radps * speed_radps, rated_shaft_torque_Nm(p));
  };
  const double best_radps =
      p.rotor.table.optimum(p.fine_pitch_rad).tsr * wind_mps / p.rotor.radius_m;
  const double low_radps = 0.7 * best_radps;
  const double high_radps = std::max(1.4 * best_radps, p.rated_rotor_speed_radps);
  if (low_radps >= p.rated_rotor_speed_radps) return p.rated_rotor_speed_radps;
  if (excess_Nm(low_radps) <= 0.0) {
    throw Error(p.name + ": region2_gain_Nms2prad2 " + std::to_string(p.region2_gain_Nms2prad2) +
                " stalls the rotor; its table asks for about " +
                std::to_string(p.rotor.optimal_torque_gain_Nms2prad2(p.fine_pitch_rad) *
                               p.gearbox_efficiency / ratio_cubed));
  }
  return std::min(falling_root(excess_Nm, low_radps, high_radps), p.rated_rotor_speed_radps);
}

/// Pitch at which the rotor gives this torque, the one towards feather.
double balancing_pitch_rad(const TurbineParams& p, double wind_mps, double speed_radps,
                           double torque_Nm) {
  const auto excess_Nm = [&](double pitch_rad) {
    return p.rotor.torque_Nm(wind_mps, speed_radps, pitch_rad) - torque_Nm;
  };
  const double last_rad = std::min(p.max_pitch_rad, p.rotor.table.pitch_rad().back());
  if (excess_Nm(last_rad) >= 0.0) {
    throw Error(p.name + ": no steady state at " + std::to_string(wind_mps) +
                " m/s: the rotor gives more than rated torque at every pitch of its table");
  }
  return falling_root(excess_Nm, p.fine_pitch_rad, last_rad);
}

}  // namespace

OperatingPoint steady_state(const TurbineParams& p, double wind_mps) {
  if (!(wind_mps > 0.0)) {
    throw Error(p.name + ": no steady state at " + std::to_string(wind_mps) +
                " m/s; expected a wind speed above 0");
  }
  const double speed_radps = tracking_speed_radps(p, wind_mps);
  const double to_generator = p.gearbox_efficiency / p.gearbox_ratio;
  double pitch_rad = p.fine_pitch_rad;
  if (speed_radps == p.rated_rotor_speed_radps &&
      p.rotor.torque_Nm(wind_mps, speed_radps, pitch_rad) > rated_shaft_torque_Nm(p)) {
    pitch_rad = balancing_pitch_rad(p, wind_mps, speed_radps, rated_shaft_torque_Nm(p));
  }
  const RotorAero::Loads loads = p.rotor.loads(wind_mps, speed_radps, pitch_rad);
  const double generator_torque_Nm = loads.torque_Nm * to_generator;
  return {.wind_mps = wind_mps,
          .rotor_speed_radps = speed_radps,
          .pitch_rad = pitch_rad,
          .generator_torque_Nm = generator_torque_Nm,
          .electrical_power_W =
              p.generator_efficiency * generator_torque_Nm * p.gearbox_ratio * speed_radps,
          .thrust_N = loads.thrust_N};
}

SlowState state_at(const TurbineParams& params, const OperatingPoint& point) {
  SlowState state{};
  state[kRotorSpeed] = point.rotor_speed_radps;
  state[kTowerX] = params.tower.rest_offset_m + point.thrust_N / params.tower.stiffness_Npm;
  state[kPitch] = point.pitch_rad;
  state[kGeneratorTorque] = point.generator_torque_Nm;
  return state;
}

}  // namespace lac::sim
