// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/filters.hpp"

namespace lac {

/// Generator speed for the control loops: low-pass, then a notch that takes out the blade-passing
/// frequency (3P). The centre of the notch follows the slowly filtered speed (methods section 12):
///
///   f_notch = n_blades Omega_slow/(2 pi i_GB)
///
/// The filter coefficients need a tangent; they are computed anew only when the centre has moved
/// by more than 0.1 %, a hundredth of a usual notch width.
class SpeedFilter {
 public:
  struct Params {
    double low_pass_hz = 1.0;
    double notch_bandwidth_hz = 0.1;  // 0: no notch
    double notch_depth = 0.01;        // gain at the centre
    double notch_tracking_hz = 0.01;  // low-pass of Omega_slow
    int blades = 3;
    double gearbox_ratio = 1.0;
    double min_speed_radps = 0.0;  // generator side; the notch follows the speed from here ...
    double max_speed_radps = 0.0;  // ... to here
  };
  struct State {
    LowPass1 low_pass;
    LowPass1 slow;
    Notch notch;
    Notch::Coefficients coefficients;
    double centre_radps = 0.0;  // Omega_slow that the coefficients belong to
    void visit(StateArchive& a) {
      a(low_pass), a(slow), a(notch), a(coefficients), a(centre_radps);
    }
  };

  /// Precondition: all frequencies below the Nyquist frequency (FeedbackParams::check).
  SpeedFilter(const Params& params, double time_step_s);

  /// Generator speed in, filtered generator speed out [rad/s]. Starts settled at the first input.
  double step(double speed_radps, State& state) const noexcept;

  /// Centre frequency of the notch at that generator speed.
  static double notch_centre_hz(const Params& params, double speed_radps);

 private:
  void follow(double slow_radps, State& state) const noexcept;

  Params params_;
  double time_step_s_;
  double low_pass_factor_;
  double slow_factor_;
};

}  // namespace lac
