// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/rotor_table.hpp"

namespace lac {

/// Quasi-steady torque and thrust of a rotor (methods section 11), with f = rho pi R^2 / 2:
///
///     lambda = Omega R / v      M_a = f R v^2 c_P(lambda, theta) / lambda      F_a = f v^2 c_T
///
/// v is the wind relative to the rotor. Outside its table lambda is clamped to the edge in all
/// three places, so that the torque stays finite at standstill and vanishes with the wind. Wind
/// from behind (v < 0) is not modelled: no torque, no thrust.
struct RotorAero {
  RotorTable table;
  double radius_m;
  double air_density_kgpm3;

  struct Loads {
    double torque_Nm = 0.0;
    double thrust_N = 0.0;
  };

  Loads loads(double wind_mps, double rotor_speed_radps, double pitch_rad) const noexcept;
  double torque_Nm(double wind_mps, double rotor_speed_radps, double pitch_rad) const noexcept {
    return loads(wind_mps, rotor_speed_radps, pitch_rad).torque_Nm;
  }
  double thrust_N(double wind_mps, double rotor_speed_radps, double pitch_rad) const noexcept {
    return loads(wind_mps, rotor_speed_radps, pitch_rad).thrust_N;
  }

  /// Partial derivatives of M_a, for wind and rotor speed > 0 inside the table; slopes of c_P over
  /// one table step. At constant Omega the wind changes lambda too.
  struct TorqueSlopes {
    double per_wind = 0.0;         // N m / (m/s)
    double per_rotor_speed = 0.0;  // N m / (rad/s)
    double per_pitch = 0.0;        // N m / rad
  };
  TorqueSlopes torque_slopes(double wind_mps, double rotor_speed_radps,
                             double pitch_rad) const noexcept;

  /// k in M = k Omega^2 (rotor side) that holds the rotor at its best tip-speed ratio:
  /// f R^3 c_Popt / lambda_opt^3, with the pitch at `min_pitch_rad` or above.
  double optimal_torque_gain_Nms2prad2(double min_pitch_rad) const noexcept;

  double disk_factor_kgpm() const noexcept;  // f = rho pi R^2 / 2
};

}  // namespace lac
