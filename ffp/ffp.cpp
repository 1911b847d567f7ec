// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace lac {
namespace {

// The schedule is looked up again when the mean wind has moved by this much.
constexpr double kScheduleStep_mps = 0.01;
// A lead that was too short must have this much to spare to be used again.
constexpr double kLeadToSpare_s = 0.1;
// A lead that moves by more in one step has changed its gate.
constexpr double kGateChange_s = 0.2;
// The start of the low-pass has died out to e^-2 after this many of its time constants.
constexpr double kSettledTimeConstants = 2.0;
// Without wind the last rate is not worth much: it leaves quickly, but without a jerk.
constexpr double kLossFade_s = 0.5;

bool is_on(FfpReason reason) {
  return reason == FfpReason::None || reason == FfpReason::RateLimited;
}

bool is_usable(const Ffp::Inputs& in) {
  return in.monitor_authority >= 0.0 && in.monitor_authority <= 1.0 &&
         std::isfinite(in.monitor_trim_s);
}

}  // namespace

const char* text_of(FfpReason reason) {
  switch (reason) {
    case FfpReason::None:
      return "on";
    case FfpReason::NoWind:
      return "no valid lidar wind speed";
    case FfpReason::Filling:
      return "the buffer is filling";
    case FfpReason::LeadTooShort:
      return "the lead time is too short for filter and actuator";
    case FfpReason::BufferTooLong:
      return "the buffer time exceeds LongestBuffer";
    case FfpReason::BelowThreshold:
      return "the wind speed is below ThresholdSpeed";
    case FfpReason::RateLimited:
      return "the rate is cut to MaximumRate";
    case FfpReason::OutsideCurve:
      return "the wind speed is outside the static pitch curve";
    case FfpReason::AuthorityReduced:
      return "the monitor allows a part of it only";
    case FfpReason::MonitorInvalid:
      return "the monitor's authority is not within 0 and 1, or its trim not a number";
  }
  return "unknown";
}

double filter_delay_s(double cutoff_hz, double frequency_hz) {
  const double wc = radps_from_hz(cutoff_hz), w = radps_from_hz(frequency_hz);
  return w > 0.0 ? std::atan(w / wc) / w : 1.0 / wc;
}

double actuator_delay_s(double actuator_hz, double damping, double frequency_hz) {
  if (actuator_hz <= 0.0) return 0.0;
  const double w0 = radps_from_hz(actuator_hz), w = radps_from_hz(frequency_hz);
  return w > 0.0 ? std::atan2(2.0 * damping * w * w0, w0 * w0 - w * w) / w : 2.0 * damping / w0;
}

Ffp::Ffp(FfpParams params, double time_step_s)
    : params_(std::move(params)), time_step_s_(time_step_s) {}

Ffp::State Ffp::initial_state() const {
  State s;
  s.line = DelayLine(params_.longest_buffer_s, time_step_s_);
  return s;
}

void Ffp::schedule(double mean_speed_mps, State& s) const noexcept {
  if (std::abs(mean_speed_mps - s.scheduled_at_mps) < kScheduleStep_mps) return;
  s.scheduled_at_mps = mean_speed_mps;
  s.cutoff_hz = params_.cutoff_hz.at(mean_speed_mps);
  s.filter_factor = LowPass1::factor(s.cutoff_hz, time_step_s_);
  s.filter_and_actuator_s = filter_delay_s(s.cutoff_hz, params_.delay_frequency_hz) +
                            actuator_delay_s(params_.actuator_frequency_hz,
                                             params_.actuator_damping, params_.delay_frequency_hz);
}

void Ffp::forget_wind(State& s) const noexcept {
  s.low_pass = {};
  s.line.clear();
  s.running_s = 0.0;
  s.buffer_started = false;
  s.above_threshold = false;
}

FfpReason Ffp::update_wind(const Inputs& in, State& s, Outputs& out) const noexcept {
  if (std::isfinite(in.mean_speed_mps)) {
    schedule(in.mean_speed_mps, s);
    out.cutoff_hz = s.cutoff_hz;
    out.lead_needed_s = s.filter_and_actuator_s + 0.5 * in.window_s - params_.buffer_trim_s;
    if (params_.use_monitor && is_usable(in)) out.lead_needed_s -= in.monitor_trim_s;
  }
  if (!in.valid || !std::isfinite(in.rews_mps) || !std::isfinite(in.mean_speed_mps)) {
    forget_wind(s);
    return FfpReason::NoWind;
  }
  out.filtered_mps = s.low_pass.step(in.rews_mps, s.filter_factor);
  s.line.push(out.filtered_mps);
  s.running_s += time_step_s_;
  return update_buffer(in, s, out);
}

FfpReason Ffp::update_buffer(const Inputs& in, State& s, Outputs& out) const noexcept {
  const double wanted_s = in.lead_s - out.lead_needed_s;
  const bool gate_changed = std::abs(in.lead_s - s.last_lead_s) > kGateChange_s;
  if (!s.buffer_started) {
    s.buffer_time_s = wanted_s;
  } else if (gate_changed) {  // what comes in is another part of the wind: no rate out of the jump
    s.buffer_time_s += in.lead_s - s.last_lead_s;
    s.has_previous = false;
  }
  s.buffer_started = true;
  s.last_lead_s = in.lead_s;
  s.buffer_time_s +=
      (wanted_s - s.buffer_time_s) * time_step_s_ / (params_.buffer_time_constant_s + time_step_s_);
  out.buffer_time_s = s.buffer_time_s;
  s.lead_short = wanted_s < (s.lead_short ? kLeadToSpare_s : 0.0);
  if (s.lead_short || s.buffer_time_s < 0.0) return FfpReason::LeadTooShort;
  if (s.buffer_time_s > params_.longest_buffer_s) return FfpReason::BufferTooLong;
  const double settling_s = kSettledTimeConstants / radps_from_hz(s.cutoff_hz);
  if (!s.line.holds(s.buffer_time_s) || s.running_s < s.buffer_time_s + settling_s) {
    return FfpReason::Filling;
  }
  out.buffered_mps = s.line.at(s.buffer_time_s);
  return FfpReason::None;
}

FfpReason Ffp::update_pitch(State& s, Outputs& out) const noexcept {
  const LookupTable& curve = params_.static_pitch_rad;
  out.pitch_rad = curve.at(out.buffered_mps);
  const double rate = s.has_previous ? (out.pitch_rad - s.previous_pitch_rad) / time_step_s_ : 0.0;
  s.previous_pitch_rad = out.pitch_rad;
  s.has_previous = true;
  s.last_rate_radps = std::clamp(rate, -params_.max_rate_radps, params_.max_rate_radps);

  const double margin = s.above_threshold ? params_.hysteresis_mps : 0.0;
  s.above_threshold = out.buffered_mps > params_.threshold_mps - margin;
  if (!s.above_threshold) return FfpReason::BelowThreshold;
  if (out.buffered_mps < curve.x().front() || out.buffered_mps > curve.x().back()) {
    return FfpReason::OutsideCurve;
  }
  return s.last_rate_radps == rate ? FfpReason::None : FfpReason::RateLimited;
}

void Ffp::fade(FfpReason reason, State& s) const noexcept {
  const double time_s = reason == FfpReason::NoWind ? std::min(kLossFade_s, params_.fade_time_s)
                                                    : params_.fade_time_s;
  const double change = time_step_s_ / time_s;
  s.active = std::clamp(s.active + (is_on(reason) ? change : -change), 0.0, 1.0);
}

FfpReason Ffp::follow_monitor(const Inputs& in, State& s) const noexcept {
  if (!params_.use_monitor) {
    s.allowed = 1.0;
    return FfpReason::None;
  }
  const double wanted = is_usable(in) ? in.monitor_authority : 0.0;
  const double step = time_step_s_ / kLossFade_s;
  s.allowed += std::clamp(wanted - s.allowed, -step, step);
  if (!is_usable(in)) return FfpReason::MonitorInvalid;
  return s.allowed < 1.0 ? FfpReason::AuthorityReduced : FfpReason::None;
}

Ffp::Outputs Ffp::step(const Inputs& in, State& s) const noexcept {
  Outputs out;
  out.reason = update_wind(in, s, out);
  if (out.reason == FfpReason::None) {
    out.reason = update_pitch(s, out);
  } else {
    s.has_previous = false;
  }
  fade(out.reason, s);
  const FfpReason monitor = follow_monitor(in, s);
  if (is_on(out.reason) && monitor != FfpReason::None) out.reason = monitor;
  out.active = s.active;
  out.allowed = s.allowed;
  out.rate_radps = s.active * s.last_rate_radps * s.allowed;
  return out;
}

}  // namespace lac
