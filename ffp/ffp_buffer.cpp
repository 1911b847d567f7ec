// SPDX-License-Identifier: Apache-2.0
// The half of Ffp before the pitch curve: schedules, low-pass and buffer.
#include <cmath>

#include "core/units.hpp"
#include "ffp/ffp.hpp"

namespace lac {
namespace {

// The schedule is looked up again when mean wind or turbulence factor have moved by this much.
constexpr double kScheduleStep_mps = 0.01;
constexpr double kScheduleStep_factor = 1e-3;
// A lead that was too short must have this much to spare to be used again.
constexpr double kLeadToSpare_s = 0.1;
// A lead that moves by more in one step has changed its gate.
constexpr double kGateChange_s = 0.2;
// The start of the low-pass has died out to e^-2 after this many of its time constants.
constexpr double kSettledTimeConstants = 2.0;
}  // namespace

double Ffp::damping_at(double mean_speed_mps) const noexcept {
  return params_.filter_order == 1 ? 0.0 : params_.damping.at(mean_speed_mps);
}

void Ffp::schedule(const Inputs& in, State& s) const noexcept {
  if (!params_.turbulence_factor.empty()) {
    const double wanted = std::isfinite(in.turbulence_intensity)
                              ? params_.turbulence_factor.at(in.turbulence_intensity)
                              : 1.0;
    s.turbulence_factor += (wanted - s.turbulence_factor) * time_step_s_ /
                           (params_.buffer_time_constant_s + time_step_s_);
  }
  if (std::abs(in.mean_speed_mps - s.scheduled_at_mps) < kScheduleStep_mps &&
      std::abs(s.turbulence_factor - s.scheduled_factor) < kScheduleStep_factor) {
    return;
  }
  s.scheduled_at_mps = in.mean_speed_mps;
  s.scheduled_factor = s.turbulence_factor;
  s.cutoff_hz = params_.cutoff_hz.at(in.mean_speed_mps) * s.turbulence_factor;
  const double damping = damping_at(in.mean_speed_mps);
  s.filter =
      FeedforwardLowPass::coefficients(params_.filter_order, s.cutoff_hz, damping, time_step_s_);
  const double filter_s =
      low_pass_delay_s(params_.filter_order, s.cutoff_hz, damping, params_.delay_frequency_hz);
  s.filter_and_actuator_s =
      filter_s + actuator_delay_s(params_.actuator_frequency_hz, params_.actuator_damping,
                                  params_.delay_frequency_hz);
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
    schedule(in, s);
    out.cutoff_hz = s.cutoff_hz;
    if (!params_.fixed_buffer_s) {
      out.lead_needed_s =
          s.filter_and_actuator_s + 0.5 * in.window_s - params_.buffer_trim_s.at(in.mean_speed_mps);
      if (params_.use_monitor && in.monitor_is_usable()) out.lead_needed_s -= in.monitor_trim_s;
    }
  }
  if (!in.valid || !std::isfinite(in.rews_mps + in.mean_speed_mps + in.lead_s + in.window_s)) {
    forget_wind(s);
    return FfpReason::NoWind;
  }
  out.filtered_mps = s.low_pass.step(in.rews_mps, s.filter);
  s.line.push(out.filtered_mps);
  s.running_s += time_step_s_;
  return update_buffer(in, s, out);
}

FfpReason Ffp::update_buffer(const Inputs& in, State& s, Outputs& out) const noexcept {
  const double trim_s = params_.use_monitor && in.monitor_is_usable() ? in.monitor_trim_s : 0.0;
  const double wanted_s =
      params_.fixed_buffer_s ? *params_.fixed_buffer_s + trim_s : in.lead_s - out.lead_needed_s;
  const bool gate_changed = std::abs(in.lead_s - s.last_lead_s) > kGateChange_s;
  if (!s.buffer_started) {
    s.buffer_time_s = wanted_s;
  } else if (gate_changed) {  // what comes in is another part of the wind: no rate out of the jump
    if (!params_.fixed_buffer_s) s.buffer_time_s += in.lead_s - s.last_lead_s;
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
  const double settling_s =
      kSettledTimeConstants *
      low_pass_delay_s(params_.filter_order, s.cutoff_hz, damping_at(s.scheduled_at_mps), 0.0);
  if (!s.line.holds(s.buffer_time_s) || s.running_s < s.buffer_time_s + settling_s) {
    return FfpReason::Filling;
  }
  out.buffered_mps = s.line.at(s.buffer_time_s);
  return FfpReason::None;
}

}  // namespace lac
