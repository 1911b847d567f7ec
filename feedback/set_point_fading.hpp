// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/filters.hpp"

namespace lac {

/// One signal that keeps the torque and the pitch loop from working against each other (methods
/// section 12):
///
///   d = DeltaOmega [(theta - theta_min)/DeltaTheta - (P_ref - P)/DeltaP]  within +-DeltaOmega,
///
/// then low-passed. The torque loop aims at Omega_rated - max(d, 0): while the blades pitch, it
/// sits on its upper limit. The pitch loop aims at Omega_rated - min(d, 0): while power is short,
/// it sits on the fine pitch. Powers are mechanical, at the generator.
class SetPointFading {
 public:
  struct Params {
    double speed_range_radps = 0.0;  // DeltaOmega, generator side
    double pitch_range_rad = 1.0;    // DeltaTheta
    double power_range_W = 1.0;      // DeltaP
    double low_pass_hz = 0.1;
  };
  using State = LowPass1;

  SetPointFading(const Params& params, double time_step_s)
      : range_radps_(params.speed_range_radps),
        radps_per_rad_(params.speed_range_radps / params.pitch_range_rad),
        radps_per_W_(params.speed_range_radps / params.power_range_W),
        factor_(LowPass1::factor(params.low_pass_hz, time_step_s)) {}

  /// Shift d [rad/s]; starts settled at the first input.
  double step(double pitch_above_fine_rad, double power_short_W, State& state) const noexcept {
    const double d = radps_per_rad_ * pitch_above_fine_rad - radps_per_W_ * power_short_W;
    return state.step(std::clamp(d, -range_radps_, range_radps_), factor_);
  }

 private:
  double range_radps_;
  double radps_per_rad_;
  double radps_per_W_;
  double factor_;
};

}  // namespace lac
