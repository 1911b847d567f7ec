// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "feedback/limited_pi.hpp"

namespace lac {

/// Where the torque demand stands between its limits.
enum class TorqueRegion { Off, HeldLow, Optimal, HeldRated, Rated };

/// The usual number: 1, 1.5, 2, 2.5, 3.
double region_number(TorqueRegion region) noexcept;

/// Generator torque over speed as one PI law between two limits (methods section 12). With
/// M_up = min(g P_rated/Omega, M_max) for constant power, min(g M_rated, M_max) for constant
/// torque, and M_opt = min(k Omega^2, M_up), the lower half below (Omega_1.5 + Omega_rated)/2:
///
///   lower half: reference Omega_1.5,             limits [0, M_low]
///   upper half: reference Omega_rated - max(d,0), limits [M_opt, M_up]
///
/// M_low is M_opt, but below Omega_1.5 no more than the straight line that starts with zero at
/// the cut-in speed, so that the torque vanishes without a step. Regions: 1 no torque, 1.5 and
/// 2.5 the PI at work around its reference, 2 on k Omega^2, 3 on M_up.
class TorqueControl {
 public:
  enum class AboveRated { ConstantPower, ConstantTorque };
  struct Params {
    double rated_speed_radps = 0.0;  // all speeds on the generator side
    double rated_torque_Nm = 0.0;
    double max_torque_Nm = 0.0;
    double max_rate_Nmps = 0.0;
    double cut_in_speed_radps = 0.0;
    double low_speed_radps = 0.0;  // Omega_1.5
    double optimal_gain_Nms2prad2 = 0.0;
    AboveRated above_rated = AboveRated::ConstantPower;
    LimitedPi::Gains gains;  // N m/(rad/s), s
  };
  using State = LimitedPi;
  struct Output {
    double torque_Nm = 0.0;
    TorqueRegion region = TorqueRegion::Off;
  };

  TorqueControl(const Params& params, double time_step_s)
      : params_(params), time_step_s_(time_step_s) {}

  /// Starts at `torque_Nm`, brought between the limits of that speed.
  Output start(double speed_radps, double power_level, double torque_Nm,
               State& state) const noexcept;

  /// `set_point_shift_radps` is d of SetPointFading, `power_level` is g.
  Output step(double speed_radps, double set_point_shift_radps, double power_level,
              State& state) const noexcept;

  /// The steady law without PI: M_opt below rated, M_up if `above_rated`.
  double steady_torque_Nm(double speed_radps, double power_level, bool above_rated) const noexcept;

 private:
  struct Task {
    double reference_radps;
    LimitedPi::Limits limits;
    bool upper_half;
  };
  Task task(double speed_radps, double shift_radps, double power_level) const noexcept;
  static TorqueRegion region(double torque_Nm, const Task& task) noexcept;
  double upper_limit(double speed_radps, double power_level) const noexcept;

  Params params_;
  double time_step_s_;
};

}  // namespace lac
