// SPDX-License-Identifier: Apache-2.0
#include "feedback/feedback.hpp"

#include <algorithm>
#include <cmath>

namespace lac {

void Feedback::State::visit(StateArchive& a) {
  a(started), a(held_steps), a(feedforward_bad), a(power_level_bad), a(power_level);
  a(speed), a(fading), a(torque), a(pitch), a(actuator);
  a(last.pitch_rad), a(last.torque_Nm), a(last.speed_filtered_radps), a(last.pitch_integral_rad);
  a(last.set_point_shift_radps), a(last.region);
}

Feedback::Feedback(const FeedbackParams& params, double time_step_s)
    : params_(params),
      time_step_s_(time_step_s),
      speed_filter_(params.speed, time_step_s),
      fading_(params.fading, time_step_s),
      torque_(params.torque, time_step_s),
      pitch_(params.pitch, time_step_s) {
  if (params.use_actuator) actuator_.emplace(params.actuator, time_step_s);
}

Feedback::Outputs Feedback::step(const Inputs& in, State& state, Events& events) const noexcept {
  if (!in.good || !std::isfinite(in.generator_speed_radps) || !std::isfinite(in.pitch_rad)) {
    return hold(in, state, events);
  }
  events.recovered_after_steps = state.held_steps;
  state.held_steps = 0;
  if (state.started) {
    advance(in, state, events);
  } else {
    start(in, state);
  }
  return state.last;
}

Feedback::Outputs Feedback::hold(const Inputs& in, State& state, Events& events) const noexcept {
  events.hold_began = state.held_steps == 0;
  ++state.held_steps;
  if (!state.started) {
    state.last.pitch_rad =
        std::isfinite(in.pitch_rad) ? in.pitch_rad : params_.pitch.fine_pitch_rad;
  }
  return state.last;
}

void Feedback::start(const Inputs& in, State& state) const noexcept {
  const double speed = speed_filter_.step(in.generator_speed_radps, state.speed);
  const double measured = std::isfinite(in.generator_torque_Nm) ? in.generator_torque_Nm : 0.0;
  const double torque = measured > 0.0 ? measured
                                       : torque_.steady_torque_Nm(speed, state.power_level,
                                                                  pitch_.is_pitching(in.pitch_rad));
  state.last.region = torque_.start(speed, state.power_level, torque, state.torque).region;
  pitch_.start(speed, in.pitch_rad, state.pitch);
  state.actuator = {in.pitch_rad, 0.0};
  state.last.torque_Nm = state.torque.output();
  state.last.pitch_rad = in.pitch_rad;
  state.last.speed_filtered_radps = speed;
  state.last.pitch_integral_rad = state.pitch.integral();
  state.last.set_point_shift_radps = shift(in.pitch_rad, state);
  state.started = true;
}

void Feedback::advance(const Inputs& in, State& state, Events& events) const noexcept {
  Outputs& out = state.last;
  move_power_level(in.power_level, state, events);
  out.speed_filtered_radps = speed_filter_.step(in.generator_speed_radps, state.speed);
  out.set_point_shift_radps = shift(in.pitch_rad, state);

  const TorqueControl::Output torque = torque_.step(
      out.speed_filtered_radps, out.set_point_shift_radps, state.power_level, state.torque);
  out.torque_Nm = torque.torque_Nm;
  out.region = torque.region;

  const double rate = feedforward_rate(in.feedforward_rate_radps, state, events);
  const double pitch = pitch_.step(out.speed_filtered_radps, out.set_point_shift_radps,
                                   in.pitch_rad, rate, state.pitch);
  out.pitch_rad = actuator_ ? actuator_->step(pitch, state.actuator) : pitch;
  out.pitch_integral_rad = state.pitch.integral();
}

void Feedback::move_power_level(std::optional<double> wanted, State& state,
                                Events& events) const noexcept {
  // Records are single precision: a level of 1.1 arrives as 1.10000002.
  constexpr double kRounding = 1e-6;
  const bool bad = wanted && !(*wanted >= 0.0 && *wanted <= params_.max_power_level + kRounding);
  events.power_level_lost = bad && !state.power_level_bad;
  state.power_level_bad = bad;
  const double target = wanted && !bad ? *wanted : 1.0;
  const double change = params_.power_level_rate_per_s * time_step_s_;
  state.power_level += std::clamp(target - state.power_level, -change, change);
}

double Feedback::feedforward_rate(double given_radps, State& state, Events& events) const noexcept {
  const bool bad = !std::isfinite(given_radps);
  events.feedforward_lost = bad && !state.feedforward_bad;
  state.feedforward_bad = bad;
  return bad ? 0.0 : given_radps;
}

double Feedback::shift(double pitch_rad, State& state) const noexcept {
  const TorqueControl::Params& rated = params_.torque;
  const double power_short_W = state.power_level * rated.rated_torque_Nm * rated.rated_speed_radps -
                               state.last.torque_Nm * state.last.speed_filtered_radps;
  return fading_.step(pitch_rad - params_.pitch.fine_pitch_rad, power_short_W, state.fading);
}

}  // namespace lac
