// SPDX-License-Identifier: Apache-2.0
#include "feedback/torque_control.hpp"

#include <algorithm>

namespace lac {

double region_number(TorqueRegion region) noexcept {
  return 1.0 + 0.5 * static_cast<int>(region);
}

double TorqueControl::upper_limit(double speed_radps, double power_level) const noexcept {
  const double rated = power_level * params_.rated_torque_Nm;
  const bool constant_power = params_.above_rated == AboveRated::ConstantPower;
  // Below the low speed M_opt is the limit, and the quotient would lose its meaning.
  const double speed = std::max(speed_radps, params_.low_speed_radps);
  const double torque = constant_power ? rated * params_.rated_speed_radps / speed : rated;
  return std::min(torque, params_.max_torque_Nm);
}

TorqueControl::Task TorqueControl::task(double speed_radps, double shift_radps,
                                        double power_level) const noexcept {
  const Params& p = params_;
  const double up = upper_limit(speed_radps, power_level);
  const double speed = std::max(speed_radps, 0.0);
  const double optimal = std::min(p.optimal_gain_Nms2prad2 * speed * speed, up);
  if (speed >= 0.5 * (p.low_speed_radps + p.rated_speed_radps)) {
    return {p.rated_speed_radps - std::max(shift_radps, 0.0), {optimal, up, p.max_rate_Nmps}, true};
  }
  const double low_torque = p.optimal_gain_Nms2prad2 * p.low_speed_radps * p.low_speed_radps;
  const double line =
      low_torque * (speed - p.cut_in_speed_radps) / (p.low_speed_radps - p.cut_in_speed_radps);
  const double low = speed < p.low_speed_radps ? std::clamp(line, 0.0, optimal) : optimal;
  return {p.low_speed_radps, {0.0, low, p.max_rate_Nmps}, false};
}

double TorqueControl::steady_torque_Nm(double speed_radps, double power_level,
                                       bool above_rated) const noexcept {
  const Task t = task(speed_radps, 0.0, power_level);
  return t.upper_half && !above_rated ? t.limits.min : t.limits.max;
}

TorqueRegion TorqueControl::region(double torque_Nm, const Task& task) noexcept {
  const LimitedPi::Limits& limits = task.limits;
  if (task.upper_half) {
    if (torque_Nm >= limits.max) return TorqueRegion::Rated;
    return torque_Nm > limits.min ? TorqueRegion::HeldRated : TorqueRegion::Optimal;
  }
  if (torque_Nm <= 0.0) return TorqueRegion::Off;
  return torque_Nm < limits.max ? TorqueRegion::HeldLow : TorqueRegion::Optimal;
}

TorqueControl::Output TorqueControl::start(double speed_radps, double power_level, double torque_Nm,
                                           State& state) const noexcept {
  const Task t = task(speed_radps, 0.0, power_level);
  const double torque = std::clamp(torque_Nm, t.limits.min, t.limits.max);
  state.start(speed_radps - t.reference_radps, torque, params_.gains, t.limits);
  return {torque, region(torque, t)};
}

TorqueControl::Output TorqueControl::step(double speed_radps, double set_point_shift_radps,
                                          double power_level, State& state) const noexcept {
  const Task t = task(speed_radps, set_point_shift_radps, power_level);
  const double torque =
      state.step(speed_radps - t.reference_radps, 0.0, params_.gains, t.limits, time_step_s_);
  return {torque, region(torque, t)};
}

}  // namespace lac
