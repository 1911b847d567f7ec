// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "ffp/ffp.hpp"
#include "ffp/guo_ffp_params.hpp"

namespace lac {

/// Feedforward pitch of Guo's FFP: low-pass, notch, fixed buffer, static pitch curve, rate.
///
///   theta = theta_ss(u filtered, T_buffer ago),    T_buffer: round(T_buffer/dt) steps
///
/// What theirs does not have: it is off while there is no wind or the buffer is not full, comes on
/// over the fade time of Ffp, and the sent pitch follows theta no faster than the rate limit of
/// Ffp: a step of the lidar's staircase turns by the same angle, over more steps. Filters start
/// settled at the first wind speed, each time anew after wind was lost.
class GuoFfp {
 public:
  struct State {
    LowPass1 low_pass;
    Notch notch;
    DelayLine line;
    double sent_pitch_rad = 0.0;
    bool on = false;
    double active = 0.0;
    void visit(StateArchive& a) {
      a(low_pass), a(notch), a(line), a(sent_pitch_rad), a(on), a(active);
    }
  };

  GuoFfp(GuoFfpParams params, double time_step_s);
  State initial_state() const;
  /// `rews_mps` counts if `valid`. lead_needed_s of the outputs is 0: not known.
  Ffp::Outputs step(double rews_mps, bool valid, State& state) const noexcept;

 private:
  double filtered_mps(double rews_mps, State& state) const noexcept;
  FfpReason follow(Ffp::Outputs& out, State& state) const noexcept;

  GuoFfpParams params_;
  double time_step_s_;
  double buffer_s_;  // whole steps
  double low_pass_factor_ = 0.0;
  Notch::Coefficients notch_;
  double max_rate_radps_;
  double fade_time_s_;
};

}  // namespace lac
