// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/state_archive.hpp"

namespace lac {

/// The hub-height wind speed that makes a controller follow a power level it looks up over wind.
///
///   V = V_1 g/cos(psi)
///
/// g is the power level, moved within a rate; V_1 the wind speed at which the table says 1; psi
/// the yaw error, whose cosine ROSCO takes off (limited to 60 deg).
class HubWindSignal {
 public:
  struct Params {
    double rated_mps = 20.0;  // V_1: far from both ends of a table from 0 to 40 m/s
    double max_level = 1.1;
    double rate_per_s = 0.01;
  };
  struct State {
    double level = 1.0;
    bool refused = false;
    void visit(StateArchive& a) { a(level), a(refused); }
  };

  HubWindSignal(const Params& params, double time_step_s)
      : params_(params), step_(params.rate_per_s * time_step_s) {}
  /// Wind speed [m/s]. A level outside of 0 to max_level is refused: 1 is aimed at.
  double step(double level, double yaw_error_rad, State& state) const noexcept;

 private:
  Params params_;
  double step_;
};

}  // namespace lac
