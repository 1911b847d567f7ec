// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ffp/ffp.hpp"
#include "ffp/guo_ffp_params.hpp"

namespace lac {

/// FFP_v1 and FFP_v2 as they are (LegacyTiming), for comparison: a buffer of 2000 values filled
/// with the first REWS, of which the value number clamp(int(T_buffer/DT), 1, 2000) is taken, DT
/// being the single precision of record 3: a delay of one step less than that number; the error
/// value 999 through the filter but not into the buffer; filter and pitch in single precision;
/// rate by plain differences. In FFP_v2 FlagNotch switches the low-pass and nothing the notch.
class GuoFfpLegacy {
 public:
  struct State {
    std::vector<double> buffer_mps;  // a ring; newest at `newest`
    std::size_t newest = 0;
    double last_in_mps = 0.0;
    double last_out_mps = 0.0;
    double last_pitch_rad = 0.0;
    bool started = false;
    void visit(StateArchive& a) {
      a(buffer_mps), a(newest), a(last_in_mps), a(last_out_mps), a(last_pitch_rad), a(started);
    }
  };

  /// `time_step_s`: value of record 3.
  GuoFfpLegacy(GuoFfpParams params, float time_step_s);
  State initial_state() const;
  Ffp::Outputs step(double rews_mps, State& state) const noexcept;

 private:
  double filtered_mps(double rews_mps, State& state) const noexcept;

  GuoFfpParams params_;
  double time_step_s_;
  std::size_t steps_;  // delay
  bool low_pass_;
};

}  // namespace lac
