// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/rotor_aero.hpp"
#include "feedback/pitch_control.hpp"

namespace lac {

/// What the gains are designed for: one degree of freedom at rated speed and torque,
/// J dOmega/dt = M_a(v, Omega, theta) - i M_g/eta_gear.
struct DesignPlant {
  RotorAero aero;
  double inertia_kgm2 = 0.0;  // rotor + i^2 generator, about the low-speed shaft
  double gearbox_ratio = 1.0;
  double gearbox_efficiency = 1.0;
  double rated_generator_speed_radps = 0.0;
  double rated_generator_torque_Nm = 0.0;
  double fine_pitch_rad = 0.0;

  double rated_rotor_speed_radps() const { return rated_generator_speed_radps / gearbox_ratio; }
  double rated_rotor_torque_Nm() const {
    return gearbox_ratio * rated_generator_torque_Nm / gearbox_efficiency;
  }
};

/// Where the closed loop shall have its pair of poles: s^2 + 2 z w s + w^2.
struct LoopTarget {
  double damping = 0.7;
  double frequency_radps = 0.5;
};

/// A balance of aerodynamic and rated generator torque at rated speed, and the plant there.
struct OperatingPoint {
  double wind_mps = 0.0;
  double pitch_rad = 0.0;
  double speed_pole_per_s = 0.0;     // A = (dM_a/dOmega)/J
  double pitch_effect_per_s2 = 0.0;  // B_theta = (dM_a/dtheta)/J
};

/// Pitch that balances rated torque at that wind speed. Throws Error when the rotor gives less at
/// fine pitch (below rated), more at every pitch of its table, or when M_a does not fall with
/// pitch (B_theta >= 0).
OperatingPoint point_above_rated(const DesignPlant& plant, double wind_mps);

/// Wind speed that gives rated torque at rated speed with the blades at fine pitch. Throws Error
/// when there is none up to 50 m/s.
OperatingPoint rated_point(const DesignPlant& plant);

/// Pole placement (methods section 12) at each wind speed:
///   k_p i = -(2 z w + A_eff)/B_theta,  k_i i = -w^2/B_theta,  T_I = k_p/k_i
/// A_eff = A + P_a/(J Omega^2) if the torque falls with speed at constant power, else A.
/// `winds_mps` rises. Throws Error when a gain comes out negative (the target is too slow).
PitchGainSchedule design_pitch_gains(const DesignPlant& plant, const std::vector<double>& winds_mps,
                                     const LoopTarget& target, bool constant_power);

/// Torque PI around rated speed at the rated point, by the same characteristic polynomial:
///   k_p = (2 z w + A) J/i^2 eta_gear,  k_i = w^2 J/i^2 eta_gear.   [N m/(rad/s), s]
LimitedPi::Gains design_torque_gains(const DesignPlant& plant, const LoopTarget& target);

/// k of M_g = k Omega_g^2 for the best tip-speed ratio at fine pitch [N m/(rad/s)^2].
double design_optimal_gain(const DesignPlant& plant);

}  // namespace lac
