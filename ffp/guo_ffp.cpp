// SPDX-License-Identifier: Apache-2.0
#include "ffp/guo_ffp.hpp"

#include <algorithm>
#include <cmath>

namespace lac {

GuoFfp::GuoFfp(GuoFfpParams params, double time_step_s)
    : params_(std::move(params)),
      time_step_s_(time_step_s),
      buffer_s_(std::round(params_.buffer_s / time_step_s) * time_step_s),
      max_rate_radps_(FfpParams{}.max_rate_radps),
      fade_time_s_(std::max(FfpParams{}.fade_time_s, time_step_s)) {
  if (params_.low_pass) {
    low_pass_factor_ = LowPass1::factor(params_.cutoff_hz(), time_step_s);
  }
  if (params_.notch) {
    const double centre_hz = params_.notch_hz();
    notch_ = Notch::coefficients(centre_hz, 2.0 * params_.notch_den * centre_hz,
                                 params_.notch_num / params_.notch_den, time_step_s);
  }
}

GuoFfp::State GuoFfp::initial_state() const {
  State s;
  s.line = DelayLine(buffer_s_, time_step_s_);
  return s;
}

double GuoFfp::filtered_mps(double rews_mps, State& s) const noexcept {
  const double low_passed_mps =
      params_.low_pass ? s.low_pass.step(rews_mps, low_pass_factor_) : rews_mps;
  return params_.notch ? s.notch.step(low_passed_mps, notch_) : low_passed_mps;
}

FfpReason GuoFfp::follow(Ffp::Outputs& out, State& s) const noexcept {
  out.pitch_rad = params_.static_pitch_rad.at(out.buffered_mps);
  if (!s.on) s.sent_pitch_rad = out.pitch_rad;  // where it starts is no movement
  s.on = true;
  const double wanted_radps = (out.pitch_rad - s.sent_pitch_rad) / time_step_s_;
  const double rate_radps = std::clamp(wanted_radps, -max_rate_radps_, max_rate_radps_);
  s.sent_pitch_rad += rate_radps * time_step_s_;
  s.active = std::min(1.0, s.active + time_step_s_ / fade_time_s_);
  out.active = s.active;
  out.rate_radps = s.active * rate_radps;
  return rate_radps == wanted_radps ? FfpReason::None : FfpReason::RateLimited;
}

Ffp::Outputs GuoFfp::step(double rews_mps, bool valid, State& s) const noexcept {
  Ffp::Outputs out;
  out.cutoff_hz = params_.low_pass ? params_.cutoff_hz() : 0.0;
  out.buffer_time_s = buffer_s_;
  if (valid) {
    out.filtered_mps = filtered_mps(rews_mps, s);
    s.line.push(out.filtered_mps);
    if (s.line.holds(buffer_s_)) {
      out.buffered_mps = s.line.at(buffer_s_);
      out.reason = follow(out, s);
      return out;
    }
    out.reason = FfpReason::Filling;
  } else {
    s.low_pass = {};
    s.notch = {};
    s.line.clear();
  }
  s.on = false;
  s.active = 0.0;
  return out;
}

}  // namespace lac
