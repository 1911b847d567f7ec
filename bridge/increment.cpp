// SPDX-License-Identifier: Apache-2.0
#include "bridge/increment.hpp"

#include <algorithm>
#include <cmath>

namespace lac {

Increment::Increment(const Params& params, double time_step_s)
    : decay_(params.leak_time_s > 0.0 ? std::exp(-time_step_s / params.leak_time_s) : 1.0),
      weight_s_(params.leak_time_s > 0.0
                    ? -params.leak_time_s * std::expm1(-time_step_s / params.leak_time_s)
                    : time_step_s),
      authority_rad_(params.authority_rad),
      fade_steps_(params.fade_time_s / time_step_s) {}

bool Increment::step(bool on, double rate_radps, State& s) const noexcept {
  if (!on) {
    if (s.on) s.fade_step_rad = std::abs(s.pitch_rad) / fade_steps_;
    s.on = false;
    s.pitch_rad -= std::clamp(s.pitch_rad, -s.fade_step_rad, s.fade_step_rad);
    return false;
  }
  s.on = true;
  const double wanted_rad = decay_ * s.pitch_rad + weight_s_ * rate_radps;
  s.pitch_rad = std::clamp(wanted_rad, -authority_rad_, authority_rad_);
  return s.pitch_rad != wanted_rad;
}

}  // namespace lac
