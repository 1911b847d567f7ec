// SPDX-License-Identifier: Apache-2.0
#include "monitor/monitor.hpp"

#include <algorithm>
#include <cmath>

namespace lac {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
// The buffer moves no faster than this: it stretches the wind by as much.
constexpr double kTrimRate = 0.01;

std::size_t ticks(double time_s, double tick_s) {
  return static_cast<std::size_t>(std::max(1.0, std::round(time_s / tick_s)));
}

/// What the newest product counts: the exact mean first, forgetting then.
double share(double tick_s, double compared_s, double memory_s) noexcept {
  return tick_s / std::min(compared_s, memory_s);
}

}  // namespace

Monitor::Monitor(const MonitorParams& params, double time_step_s)
    : params_(params),
      steps_per_tick_(static_cast<int>(ticks(params.update_interval_s, time_step_s))),
      tick_s_(steps_per_tick_ * time_step_s),
      turbine_(params.turbine, time_step_s),
      moddemeijer_(ticks(params.lag_range_s, tick_s_), ticks(params.sample_spacing_s, tick_s_),
                   tick_s_),
      authority_(params.authority),
      lag_range_(ticks(params.lag_range_s, tick_s_)),
      buffered_delay_s_(params.actuator_delay_s + turbine_.delay_s()) {}

Monitor::State Monitor::initial_state() const {
  const bool moddemeijer = params_.delay_method == DelayMethod::Moddemeijer;
  const std::size_t margin =
      moddemeijer ? Moddemeijer::margin(ticks(params_.sample_spacing_s, tick_s_)) : 0;
  State s;
  s.lidar_line = DelayLine(params_.longest_lead_s, tick_s_);
  s.buffered_line = DelayLine(buffered_delay_s_, tick_s_);
  s.moments = LaggedMoments(lag_range_ + margin, margin);
  s.moddemeijer = moddemeijer_.initial_state();
  s.lidar_bands = BandSpectra(params_.band_hz, params_.band_width_hz, tick_s_);
  s.feedforward_bands = s.lidar_bands;
  s.authority = authority_.initial_state();
  s.last.authority = s.authority.value;
  return s;
}

Monitor::Outputs Monitor::step(const Inputs& in, State& s) const noexcept {
  const double turbine_mps = turbine_.step(in.turbine, s.turbine);
  s.turbine_mean.add(turbine_mps);
  s.lidar_mean.add(in.lidar_valid ? in.lidar_mps : kNothing);
  s.buffered_mean.add(in.buffered_mps);
  if (++s.steps_in_tick == steps_per_tick_) {
    s.steps_in_tick = 0;
    tick(in, s);
  }
  s.last.turbine_mps = turbine_mps;
  return s.last;
}

void Monitor::tick(const Inputs& in, State& s) const noexcept {
  const double lidar_mps = s.lidar_mean.take(steps_per_tick_);
  const double turbine_mps = s.turbine_mean.take(steps_per_tick_);
  const double buffered_mps = s.buffered_mean.take(steps_per_tick_);
  compare_feedforward(buffered_mps, compare(in, lidar_mps, turbine_mps, s), s);
  Evidence evidence;
  evidence.lidar_valid = std::isfinite(lidar_mps);
  evidence.turbine_valid = std::isfinite(turbine_mps);
  evidence.learned = s.compared_s >= params_.learning_s;
  const double behind_s = measured_delay_s(s);
  if (evidence.learned && evidence.lidar_valid) judge(in, behind_s, evidence, s);
  authority_.step(evidence, tick_s_, s.authority);
  s.last.authority = s.authority.value;
  s.last.reason = s.authority.reason;
}

Monitor::Pair Monitor::compare(const Inputs& in, double lidar_mps, double turbine_mps,
                               State& s) const noexcept {
  if (std::isfinite(lidar_mps)) {
    s.lidar_line.push(lidar_mps);
  } else {
    s.lidar_line.clear();
  }
  const double delay_s = in.lead_s - 0.5 * in.window_s + turbine_.delay_s();
  if (!std::isfinite(turbine_mps) || !std::isfinite(delay_s) || !s.lidar_line.holds(delay_s)) {
    s.moments.break_off();
    s.lidar_slow = s.turbine_slow = {};
    s.lidar_whole_s = 0.0;
    return {kNothing, kNothing};
  }
  const double at_rotor_mps = s.lidar_line.at(delay_s);
  s.lidar_slow.add(at_rotor_mps, tick_s_, params_.detrend_s);
  s.turbine_slow.add(turbine_mps, tick_s_, params_.detrend_s);
  s.lidar_long.add(at_rotor_mps, tick_s_, params_.memory_s);
  s.turbine_long.add(turbine_mps, tick_s_, params_.memory_s);
  s.lidar_whole_s += tick_s_;
  if (s.lidar_whole_s < params_.detrend_s) return {kNothing, kNothing};
  const Pair pair{at_rotor_mps - s.lidar_slow.mean(), turbine_mps - s.turbine_slow.mean()};
  s.compared_s += tick_s_;
  const double newest = share(tick_s_, s.compared_s, params_.memory_s);
  s.moments.add(pair.x_mps, pair.y_mps, newest);
  s.lidar_bands.add(pair.x_mps, pair.y_mps, newest);
  return pair;
}

void Monitor::compare_feedforward(double buffered_mps, const Pair& pair, State& s) const noexcept {
  if (!std::isfinite(buffered_mps)) {
    s.buffered_line.clear();
    s.buffered_slow = {};
    s.buffered_whole_s = 0.0;
    return;
  }
  s.buffered_line.push(buffered_mps);
  if (!s.buffered_line.holds(buffered_delay_s_)) return;
  const double acting_mps = s.buffered_line.at(buffered_delay_s_);
  s.buffered_slow.add(acting_mps, tick_s_, params_.detrend_s);
  s.buffered_whole_s += tick_s_;
  if (!std::isfinite(pair.y_mps) || s.buffered_whole_s < params_.detrend_s) return;
  const double f_mps = acting_mps - s.buffered_slow.mean();
  s.acted_s += tick_s_;
  s.feedforward_bands.add(f_mps, pair.y_mps, share(tick_s_, s.acted_s, params_.memory_s));
}

/// Of y behind x; not a number while it is not known.
double Monitor::measured_delay_s(State& s) const noexcept {
  if (!(s.moments.auto_x(0) > 0.0)) return kNothing;  // sums outlast gaps
  const DelayEstimate peak = correlation_delay(s.moments, lag_range_, tick_s_);
  if (params_.delay_method == DelayMethod::Correlation) {
    return peak.correlation < params_.minimum_correlation ? kNothing : peak.delay_s;
  }
  moddemeijer_.step(s.moments, s.moddemeijer);
  return peak.correlation < params_.minimum_correlation ? kNothing : s.moddemeijer.delay_s;
}

/// How much later than the lead says the feedforward acts; 0 without one.
double Monitor::off_time_s(const Inputs& in) const noexcept {
  if (!std::isfinite(in.buffer_time_s) || !(in.cutoff_hz > 0.0)) return 0.0;
  const double filter_s = low_pass_delay_s(params_.filter_order, in.cutoff_hz,
                                           params_.filter_damping, params_.delay_frequency_hz);
  return in.buffer_time_s + filter_s + params_.actuator_delay_s - in.lead_s + 0.5 * in.window_s;
}

void Monitor::judge(const Inputs& in, double behind_s, Evidence& e, State& s) const noexcept {
  Outputs& out = s.last;
  const double highest_hz = in.cutoff_hz > 0.0 ? in.cutoff_hz : params_.band_hz.back();
  const bool acts = s.acted_s >= params_.learning_s;
  out.coherence = e.coherence = s.lidar_bands.mean_coherence(highest_hz);
  const BandSpectra::Slope slope =
      acts ? s.feedforward_bands.slope(std::min(s.acted_s, 2.0 * params_.memory_s))
           : s.lidar_bands.slope(std::min(s.compared_s, 2.0 * params_.memory_s));
  out.gain = slope.value;
  e.gain = slope.value + slope.deviation;
  out.mean_ratio = e.mean_ratio = s.turbine_long.mean() / s.lidar_long.mean();
  out.delay_s = in.lead_s - 0.5 * in.window_s + behind_s;
  out.late_s = off_time_s(in) - behind_s;
  const double trimmed_s =
      std::clamp(out.trim_s - out.late_s, -params_.maximum_trim_s, params_.maximum_trim_s);
  const bool delay_is_sure = s.compared_s >= params_.memory_s;
  if (delay_is_sure) e.late_s = out.late_s + trimmed_s - out.trim_s;  // what trimming cannot mend
  if (!acts || !delay_is_sure || e.coherence < params_.authority.coherence_on ||
      !std::isfinite(trimmed_s))
    return;
  const double change_s = (trimmed_s - out.trim_s) * tick_s_ / params_.trim_time_s;
  out.trim_s += std::clamp(change_s, -kTrimRate * tick_s_, kTrimRate * tick_s_);
}

}  // namespace lac
