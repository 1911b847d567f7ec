// SPDX-License-Identifier: Apache-2.0
#include "feedback/speed_filter.hpp"

#include <algorithm>
#include <cmath>

namespace lac {
namespace {

constexpr double kCentreTolerance = 1.0e-3;

}  // namespace

SpeedFilter::SpeedFilter(const Params& params, double time_step_s)
    : params_(params),
      time_step_s_(time_step_s),
      low_pass_factor_(LowPass1::factor(params.low_pass_hz, time_step_s)),
      slow_factor_(LowPass1::factor(params.notch_tracking_hz, time_step_s)) {}

double SpeedFilter::notch_centre_hz(const Params& params, double speed_radps) {
  return params.blades * speed_radps / (2.0 * kPi * params.gearbox_ratio);
}

void SpeedFilter::follow(double slow_radps, State& state) const noexcept {
  const double centre = std::clamp(slow_radps, params_.min_speed_radps, params_.max_speed_radps);
  if (std::abs(centre - state.centre_radps) <= kCentreTolerance * state.centre_radps) return;
  state.centre_radps = centre;
  state.coefficients =
      Notch::coefficients(notch_centre_hz(params_, centre), params_.notch_bandwidth_hz,
                          params_.notch_depth, time_step_s_);
}

double SpeedFilter::step(double speed_radps, State& state) const noexcept {
  follow(state.slow.step(speed_radps, slow_factor_), state);
  return state.notch.step(state.low_pass.step(speed_radps, low_pass_factor_), state.coefficients);
}

}  // namespace lac
