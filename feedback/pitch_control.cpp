// SPDX-License-Identifier: Apache-2.0
#include "feedback/pitch_control.hpp"

#include <algorithm>

#include "core/units.hpp"

namespace lac {
namespace {

constexpr double kNearFinePitch_rad = rad_from_deg(0.5);

}  // namespace

bool PitchControl::is_pitching(double pitch_rad) const noexcept {
  return pitch_rad > params_.fine_pitch_rad + kNearFinePitch_rad;
}

void PitchControl::start(double speed_radps, double pitch_rad, State& state) const noexcept {
  const double error = speed_radps - params_.rated_speed_radps;
  const bool idle = error < 0.0 && !is_pitching(pitch_rad);
  state.start(idle ? 0.0 : error, pitch_rad, params_.gains.at(pitch_rad), limits());
}

double PitchControl::step(double speed_radps, double set_point_shift_radps, double pitch_rad,
                          double feedforward_rate_radps, State& state) const noexcept {
  const double reference = params_.rated_speed_radps - std::min(set_point_shift_radps, 0.0);
  return state.step(speed_radps - reference, feedforward_rate_radps, params_.gains.at(pitch_rad),
                    limits(), time_step_s_);
}

}  // namespace lac
