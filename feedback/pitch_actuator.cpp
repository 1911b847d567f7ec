// SPDX-License-Identifier: Apache-2.0
#include "feedback/pitch_actuator.hpp"

#include <algorithm>
#include <cmath>

namespace lac {

PitchActuator::PitchActuator(const Params& params, double time_step_s)
    : params_(params), time_step_s_(time_step_s) {
  const double w = params.frequency_radps;
  const double decay = params.damping * w;
  const double damped = w * std::sqrt(1.0 - params.damping * params.damping);
  const double fall = std::exp(-decay * time_step_s);
  const double c = fall * std::cos(damped * time_step_s);
  const double s = fall * std::sin(damped * time_step_s) / damped;
  pitch_from_pitch_ = c + decay * s;
  pitch_from_rate_ = s;
  rate_from_pitch_ = -w * w * s;
  rate_from_rate_ = c - decay * s;
}

double PitchActuator::step(double demand_rad, State& state) const noexcept {
  const double gap = state.pitch_rad - demand_rad;
  const double pitch = demand_rad + pitch_from_pitch_ * gap + pitch_from_rate_ * state.rate_radps;
  const double rate = rate_from_pitch_ * gap + rate_from_rate_ * state.rate_radps;
  const double max_rate = params_.max_rate_radps;
  const double change = max_rate * time_step_s_;
  const double allowed = std::clamp(pitch, params_.min_rad, params_.max_rad);
  const double moved = std::clamp(allowed - state.pitch_rad, -change, change);
  state.pitch_rad += moved;
  state.rate_radps = allowed == pitch ? std::clamp(rate, -max_rate, max_rate) : 0.0;
  return state.pitch_rad;
}

}  // namespace lac
