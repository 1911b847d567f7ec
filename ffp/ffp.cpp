// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace lac {
namespace {

// Without wind the last rate is not worth much: it leaves quickly, but without a jerk.
constexpr double kLossFade_s = 0.5;
constexpr double kLeastWeight = 1e-6;

bool is_on(FfpReason reason) {
  return reason == FfpReason::None || reason == FfpReason::RateLimited;
}

}  // namespace

double actuator_delay_s(double actuator_hz, double damping, double frequency_hz) {
  if (actuator_hz <= 0.0) return 0.0;
  return second_order_delay_s(actuator_hz, damping, frequency_hz);
}

Ffp::Ffp(FfpParams params, double time_step_s)
    : params_(std::move(params)), time_step_s_(time_step_s) {}

Ffp::State Ffp::initial_state() const {
  State s;
  s.line = DelayLine(params_.longest_buffer_s, time_step_s_);
  return s;
}

/// How far from the curve of rated power to the reduced one.
double Ffp::reduced_part(double power_level) const noexcept {
  if (params_.reduced_pitch_rad.empty() || !(power_level < 1.0)) return 0.0;
  return std::min(1.0, (1.0 - power_level) / (1.0 - params_.reduced_power_level));
}

double Ffp::pitch_at_rad(double wind_mps, double power_level) const noexcept {
  const double rated_rad = params_.static_pitch_rad.at(wind_mps);
  const double part = reduced_part(power_level);
  if (part == 0.0) return rated_rad;
  return std::lerp(rated_rad, params_.reduced_pitch_rad.at(wind_mps), part);
}

double Ffp::slope_at_radpmps(double wind_mps, double power_level) const noexcept {
  const double rated = params_.static_pitch_rad.slope(wind_mps);
  const double part = reduced_part(power_level);
  return part == 0.0 ? rated : std::lerp(rated, params_.reduced_pitch_rad.slope(wind_mps), part);
}

FfpReason Ffp::enter(double power_level, State& s, const Outputs& out) const noexcept {
  if (params_.entry == EntryRule::Threshold) {
    const double margin = s.above_threshold ? params_.hysteresis_mps : 0.0;
    s.above_threshold = out.buffered_mps > params_.threshold_mps - margin;
    return s.above_threshold ? FfpReason::None : FfpReason::BelowThreshold;
  }
  s.entry_weight =
      params_.entry == EntryRule::Blend
          ? blend_weight(out.buffered_mps, params_.blend_from_mps, params_.blend_to_mps)
          : slope_weight(slope_at_radpmps(out.buffered_mps, power_level),
                         params_.largest_slope_radpmps);
  return s.entry_weight > 0.0 ? FfpReason::None : FfpReason::BelowThreshold;
}

FfpReason Ffp::update_pitch(const Inputs& in, State& s, Outputs& out) const noexcept {
  const LookupTable& curve = params_.static_pitch_rad;
  // Both ends of the difference at one power level: what changes the level moves the pitch itself.
  out.pitch_rad = pitch_at_rad(out.buffered_mps, in.power_level);
  const double before_rad = pitch_at_rad(s.previous_wind_mps, in.power_level);
  const double rate = s.has_previous ? (out.pitch_rad - before_rad) / time_step_s_ : 0.0;
  s.previous_wind_mps = out.buffered_mps;
  s.has_previous = true;
  const FfpReason entry = enter(in.power_level, s, out);
  // The limit is for what is sent: the weighted rate.
  const double largest = params_.max_rate_radps / std::max(s.entry_weight, kLeastWeight);
  s.last_rate_radps = std::clamp(rate, -largest, largest);

  if (entry != FfpReason::None && out.buffered_mps <= curve.x().back()) return entry;
  if (out.buffered_mps < curve.x().front() || out.buffered_mps > curve.x().back()) {
    return FfpReason::OutsideCurve;
  }
  return s.last_rate_radps == rate ? FfpReason::None : FfpReason::RateLimited;
}

void Ffp::fade(FfpReason reason, State& s) const noexcept {
  const double time_s = reason == FfpReason::NoWind ? std::min(kLossFade_s, params_.fade_time_s)
                                                    : params_.fade_time_s;
  const double change = time_step_s_ / time_s;
  const bool weighted =
      reason == FfpReason::BelowThreshold && params_.entry != EntryRule::Threshold;
  s.active = std::clamp(s.active + (is_on(reason) || weighted ? change : -change), 0.0, 1.0);
}

FfpReason Ffp::limit_pitch(State& s, Outputs& out) const noexcept {
  const double kept_rad = s.added_pitch_rad * (1.0 - time_step_s_ / params_.largest_pitch_time_s);
  const double wanted_rad = kept_rad + out.rate_radps * time_step_s_;
  s.added_pitch_rad =
      std::clamp(wanted_rad, -*params_.largest_pitch_rad, *params_.largest_pitch_rad);
  if (s.added_pitch_rad == wanted_rad) return FfpReason::None;
  out.rate_radps = (s.added_pitch_rad - kept_rad) / time_step_s_;
  return FfpReason::PitchLimited;
}

FfpReason Ffp::follow_monitor(const Inputs& in, State& s) const noexcept {
  if (!params_.use_monitor) {
    s.allowed = 1.0;
    return FfpReason::None;
  }
  const double wanted = in.monitor_is_usable() ? in.monitor_authority : 0.0;
  const double step = time_step_s_ / kLossFade_s;
  s.allowed += std::clamp(wanted - s.allowed, -step, step);
  if (!in.monitor_is_usable()) return FfpReason::MonitorInvalid;
  return s.allowed < 1.0 ? FfpReason::AuthorityReduced : FfpReason::None;
}

Ffp::Outputs Ffp::step(const Inputs& in, State& s) const noexcept {
  Outputs out;
  out.reason = update_wind(in, s, out);
  if (out.reason == FfpReason::None) {
    out.reason = update_pitch(in, s, out);
  } else {
    s.has_previous = false;
  }
  fade(out.reason, s);
  const FfpReason monitor = follow_monitor(in, s);
  if (is_on(out.reason) && monitor != FfpReason::None) out.reason = monitor;
  out.active = s.active * s.entry_weight;
  out.allowed = s.allowed;
  out.rate_radps = out.active * s.last_rate_radps * s.allowed;
  if (params_.largest_pitch_rad && limit_pitch(s, out) != FfpReason::None) {
    out.reason = FfpReason::PitchLimited;
  }
  return out;
}

}  // namespace lac
