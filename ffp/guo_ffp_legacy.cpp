// SPDX-License-Identifier: Apache-2.0
#include "ffp/guo_ffp_legacy.hpp"

#include <algorithm>

#include "core/guo_block.hpp"

namespace lac {
namespace {

constexpr int kBufferSize = 2000;

/// Their functions return single precision.
double to_single(double value) {
  return static_cast<float>(value);
}

}  // namespace

GuoFfpLegacy::GuoFfpLegacy(GuoFfpParams params, float time_step_s)
    : params_(std::move(params)),
      time_step_s_(time_step_s),
      steps_(static_cast<std::size_t>(
          std::clamp(static_cast<int>(params_.buffer_s / time_step_s_), 1, kBufferSize) - 1)),
      low_pass_(params_.version_2 ? params_.notch : params_.low_pass) {}

GuoFfpLegacy::State GuoFfpLegacy::initial_state() const {
  State s;
  s.buffer_mps.assign(kBufferSize, 0.0);
  return s;
}

double GuoFfpLegacy::filtered_mps(double rews_mps, State& s) const noexcept {
  if (!low_pass_) return rews_mps;
  const double w = params_.cutoff_radps * time_step_s_;
  if (!s.started) s.last_in_mps = s.last_out_mps = rews_mps;
  s.last_out_mps =
      to_single(1.0 / (2.0 + w) * ((2.0 - w) * s.last_out_mps + w * rews_mps + w * s.last_in_mps));
  s.last_in_mps = rews_mps;
  return s.last_out_mps;
}

Ffp::Outputs GuoFfpLegacy::step(double rews_mps, State& s) const noexcept {
  if (!s.started) std::ranges::fill(s.buffer_mps, rews_mps);
  Ffp::Outputs out;
  out.filtered_mps = filtered_mps(rews_mps, s);
  const double before_mps = s.buffer_mps[s.newest];
  s.newest = (s.newest + 1) % kBufferSize;
  s.buffer_mps[s.newest] = out.filtered_mps != kGuoNoValue ? out.filtered_mps : before_mps;
  out.buffered_mps = s.buffer_mps[(s.newest + kBufferSize - steps_) % kBufferSize];
  out.pitch_rad = to_single(params_.static_pitch_rad.at(out.buffered_mps));
  if (!s.started) s.last_pitch_rad = out.pitch_rad;
  out.rate_radps = (out.pitch_rad - s.last_pitch_rad) / time_step_s_;
  s.last_pitch_rad = out.pitch_rad;
  s.started = true;
  out.active = 1.0;
  out.reason = FfpReason::None;
  out.buffer_time_s = static_cast<double>(steps_) * time_step_s_;
  out.cutoff_hz = low_pass_ ? params_.cutoff_hz() : 0.0;
  return out;
}

}  // namespace lac
