// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/state_archive.hpp"

namespace lac {

/// The tower accelerations that make an integrating tower damper give a wanted angle.
///
/// The damper turns fore-aft acceleration into pitch, y' = K (a_x cos h + a_y sin h), with a_x and
/// a_y in the frame of north and the nacelle direction h. Sent is what closes the gap between the
/// wanted angle and the one the damper has by now; records are single precision, so that angle is
/// summed up from the numbers as they are sent.
class TowerSignal {
 public:
  struct State {
    double angle_rad = 0.0;  // of the damper's integrator
    void visit(StateArchive& a) { a(angle_rad); }
  };
  struct Outputs {
    float fore_aft_mps2 = 0.0f;   // record 53
    float side_side_mps2 = 0.0f;  // record 54
  };

  /// K [rad s/m] of the damper.
  TowerSignal(double gain, double time_step_s) : gain_(gain), time_step_s_(time_step_s) {}
  Outputs step(double wanted_rad, double nacelle_direction_rad, State& state) const noexcept;

 private:
  double gain_;
  double time_step_s_;
};

}  // namespace lac
