// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/state_archive.hpp"

namespace lac {

/// Model of a second-order pitch actuator, theta'' + 2 z w theta' + w^2 theta = w^2 theta_c, with
/// rate and angle limits. For hosts that follow a demand without delay: what they are sent then
/// moves as the blades would. Discrete with the exact solution for a demand held over the step.
class PitchActuator {
 public:
  struct Params {
    double frequency_radps = 6.28;
    double damping = 0.7;  // 0 < z < 1
    double min_rad = 0.0;
    double max_rad = 0.0;
    double max_rate_radps = 0.0;
  };
  struct State {
    double pitch_rad = 0.0;
    double rate_radps = 0.0;
    void visit(StateArchive& a) { a(pitch_rad), a(rate_radps); }
  };

  PitchActuator(const Params& params, double time_step_s);

  /// Pitch at the end of the step over which `demand_rad` holds.
  double step(double demand_rad, State& state) const noexcept;

 private:
  Params params_;
  double time_step_s_;
  // x(k+1) - u = transition (x(k) - u) for x = (pitch, rate), u = (demand, 0)
  double pitch_from_pitch_, pitch_from_rate_, rate_from_pitch_, rate_from_rate_;
};

}  // namespace lac
