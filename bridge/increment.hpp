// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/state_archive.hpp"

namespace lac {

/// The pitch increment a neighbour gets: a leaky integral of the feedforward rate, bounded.
///
///   x' = rate - x/T,  |x| <= authority
///
/// exact for a rate that is constant over the step; T = 0: no leak. While the feedforward is off
/// x goes to zero along a straight line, within the fade time, and stays there.
class Increment {
 public:
  struct Params {
    double leak_time_s = 60.0;  // T
    double authority_rad = 0.0;
    double fade_time_s = 10.0;
  };
  struct State {
    double pitch_rad = 0.0;      // x
    double fade_step_rad = 0.0;  // per step while off
    bool on = false;
    void visit(StateArchive& a) { a(pitch_rad), a(fade_step_rad), a(on); }
  };

  Increment(const Params& params, double time_step_s);
  /// One step; `on` says whether the rate [rad/s] counts. Returns whether the authority cut it.
  bool step(bool on, double rate_radps, State& state) const noexcept;

 private:
  double decay_;     // exp(-dt/T)
  double weight_s_;  // T (1 - exp(-dt/T))
  double authority_rad_;
  double fade_steps_;
};

}  // namespace lac
