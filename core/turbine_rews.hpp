// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "core/filters.hpp"
#include "core/input_file.hpp"
#include "core/rotor_aero.hpp"
#include "core/tsr_lookup.hpp"

namespace lac {

struct TurbineRewsParams {
  RotorAero rotor;
  double inertia_kgm2 = 0.0;  // rotor and gearbox_ratio^2 times generator, about the slow shaft
  double gearbox_ratio = 1.0;
  double gearbox_efficiency = 1.0;  // generator-side over rotor-side power
  double low_pass_hz = 0.5;         // of speed, torque and pitch alike

  /// Keys RotorTable, RotorRadius, AirDensity (1.225), InertiaLowSpeedShaft, GearboxRatio,
  /// GearboxEfficiency (1), TurbineLowPass (0.5 Hz). Throws Error with file, line and key.
  static TurbineRewsParams read(InputFile& in);
  /// Throws Error with file, line and key if the time step is too long for the low-pass.
  void check_time_step(const InputFile& in, double time_step_s) const;
};

/// Rotor-effective wind speed from what the turbine measures (HM eqs. 14-17, methods section 9):
///
///     C_p/lambda^3 = 2 (i M_g/eta + J dOmega/dt)/(rho pi R^5 Omega^2)  ->  lambda,  v = Omega
///     R/lambda
///
/// Omega = Omega_g/i, torque and pitch pass the same first-order low-pass, so that they stay in
/// line; Omega is differentiated after it. The whole is late by delay_s(). One degree of freedom:
/// the motion of the tower top reads as wind.
class TurbineRews {
 public:
  struct Inputs {
    double generator_speed_radps = 0.0;
    double generator_torque_Nm = 0.0;
    double pitch_rad = 0.0;
    bool usable = true;  // measured anew and the generator is on
  };
  struct State {
    LowPass1 speed, torque, pitch;
    double running_s = 0.0;
    void visit(StateArchive& a) { a(speed), a(torque), a(pitch), a(running_s); }
  };

  TurbineRews(const TurbineRewsParams& params, double time_step_s);

  /// [m/s]; not a number while an input is not usable or not finite, without torque or rotation,
  /// until the low-pass has settled (three time constants), and outside the rotor table. [real
  /// time]
  double step(const Inputs& in, State& state) const noexcept;

  /// At low frequencies: of the low-pass, and half a step of the difference.
  double delay_s() const noexcept { return delay_s_; }

 private:
  double time_step_s_;
  double factor_;
  double delay_s_;
  double settling_s_;
  double gearbox_ratio_;
  double slow_torque_per_generator_torque_;
  double inertia_kgm2_;
  double radius_m_;
  double per_torque_and_speed_;  // 2/(rho pi R^5)
  TsrLookup lookup_;
};

}  // namespace lac
