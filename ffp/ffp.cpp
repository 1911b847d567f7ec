// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace lac {
namespace {

// The schedule is looked up again when the mean wind has moved by this much.
constexpr double kScheduleStep_mps = 0.01;

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
  s.has_previous = false;
  s.buffer_started = false;
  s.above_threshold = false;
}

FfpReason Ffp::update_wind(const Inputs& in, State& s, Outputs& out) const noexcept {
  if (!in.valid || !std::isfinite(in.rews_mps) || !std::isfinite(in.mean_speed_mps)) {
    forget_wind(s);
    return FfpReason::NoWind;
  }
  schedule(in.mean_speed_mps, s);
  out.cutoff_hz = s.cutoff_hz;
  out.filtered_mps = s.low_pass.step(in.rews_mps, s.filter_factor);
  s.line.push(out.filtered_mps);

  const double wanted_s =
      in.lead_s - s.filter_and_actuator_s - 0.5 * in.window_s + params_.buffer_trim_s;
  if (!s.buffer_started) s.buffer_time_s = wanted_s;
  s.buffer_started = true;
  s.buffer_time_s +=
      (wanted_s - s.buffer_time_s) * time_step_s_ / (params_.buffer_time_constant_s + time_step_s_);
  out.buffer_time_s = s.buffer_time_s;
  if (wanted_s < 0.0 || s.buffer_time_s < 0.0) return FfpReason::LeadTooShort;
  if (s.buffer_time_s > params_.longest_buffer_s) return FfpReason::BufferTooLong;
  if (!s.line.holds(s.buffer_time_s)) return FfpReason::Filling;
  out.buffered_mps = s.line.at(s.buffer_time_s);
  return FfpReason::None;
}

FfpReason Ffp::update_pitch(State& s, Outputs& out) const noexcept {
  out.pitch_rad = params_.static_pitch_rad.at(out.buffered_mps);
  const double rate = s.has_previous ? (out.pitch_rad - s.previous_pitch_rad) / time_step_s_ : 0.0;
  s.previous_pitch_rad = out.pitch_rad;
  s.has_previous = true;
  s.last_rate_radps = std::clamp(rate, -params_.max_rate_radps, params_.max_rate_radps);

  const double margin = s.above_threshold ? params_.hysteresis_mps : 0.0;
  s.above_threshold = out.buffered_mps > params_.threshold_mps - margin;
  if (!s.above_threshold) return FfpReason::BelowThreshold;
  return s.last_rate_radps == rate ? FfpReason::None : FfpReason::RateLimited;
}

void Ffp::fade(bool on, State& s) const noexcept {
  const double change = time_step_s_ / params_.fade_time_s;
  s.active = std::clamp(s.active + (on ? change : -change), 0.0, 1.0);
}

Ffp::Outputs Ffp::step(const Inputs& in, State& s) const noexcept {
  Outputs out;
  out.reason = update_wind(in, s, out);
  if (out.reason == FfpReason::None) {
    out.reason = update_pitch(s, out);
  } else {
    s.has_previous = false;
  }
  fade(out.reason == FfpReason::None || out.reason == FfpReason::RateLimited, s);
  out.active = s.active;
  out.rate_radps = s.active * s.last_rate_radps;
  return out;
}

}  // namespace lac
