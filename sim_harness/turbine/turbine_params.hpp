// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "core/rotor_aero.hpp"

namespace lac::sim {

/// Second-order pitch actuator, seen from the blade root.
struct PitchActuator {
  bool enabled = true;  // false: pitch = demand
  double frequency_radps = 0.0;
  double damping_ratio = 0.0;
  double rate_limit_radps = 0.0;
};

/// First-order lag of the generator torque.
struct GeneratorLag {
  double time_constant_s = 0.0;  // 0: torque = demand, without rate limit
  double torque_rate_limit_Nmps = 0.0;
};

/// Fore-aft mode of the tower, reduced to the tower top.
struct TowerMode {
  double mass_kg = 0.0;
  double stiffness_Npm = 0.0;  // m (2 pi f0)^2
  double damping_Nspm = 0.0;   // 2 d m 2 pi f0
  double rest_offset_m = 0.0;  // x_T0, down-wind positive
};

/// Everything the model knows of a turbine. Generator quantities on the high-speed side.
struct TurbineParams {
  std::string name = {};
  int number_of_blades = 3;
  double hub_height_m = 0.0;
  RotorAero rotor;

  double gearbox_ratio = 0.0;       // > 1: the generator turns faster
  double gearbox_efficiency = 0.0;  // generator-side power / rotor-side power
  double inertia_kgm2 = 0.0;  // rotor + gearbox_ratio^2 x generator, about the low-speed shaft
  double generator_efficiency = 0.0;  // electrical / mechanical power

  double rated_power_W = 0.0;  // electrical
  double rated_rotor_speed_radps = 0.0;
  double rated_torque_Nm = 0.0;
  double max_torque_Nm = 0.0;
  double region2_gain_Nms2prad2 = 0.0;  // k in M_g = k Omega_g^2 between cut-in and rated speed

  double cut_in_wind_mps = 0.0;
  double cut_out_wind_mps = 0.0;
  double min_pitch_rad = 0.0;  // stops of the pitch system
  double max_pitch_rad = 0.0;
  double fine_pitch_rad = 0.0;  // pitch below rated wind

  PitchActuator pitch_actuator = {};
  GeneratorLag generator_lag = {};
  TowerMode tower = {};
};

/// Reads a turbine file (config/turbines/<name>/turbine.yaml) and the rotor table it names, whose
/// path is relative to the turbine file. Throws Error: file, line, key, found, expected, hint.
TurbineParams load_turbine(const std::filesystem::path& path);

}  // namespace lac::sim
