// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lookup_table.hpp"
#include "feedback/limited_pi.hpp"

namespace lac {

/// PI gains over blade pitch: straight lines between the points, constant outside.
struct PitchGainSchedule {
  LookupTable proportional_s;   // k_p over pitch [rad]: rad per rad/s at the generator
  LookupTable integral_time_s;  // T_I over pitch [rad]
  LimitedPi::Gains at(double pitch_rad) const noexcept {
    return {proportional_s.at(pitch_rad), integral_time_s.at(pitch_rad)};
  }
};

/// Collective pitch (methods section 12, GUO eq. 36 and 38):
///
///   theta = k_p e + int (k_p/T_I e + theta'_FF) dt,   e = Omega_g - (Omega_rated - min(d, 0))
///
/// A speed above the reference pitches to feather. The feedforward rate theta'_FF is added before
/// the integrator and meets the angle and rate limits with it (LimitedPi).
class PitchControl {
 public:
  struct Params {
    double rated_speed_radps = 0.0;  // generator side
    double fine_pitch_rad = 0.0;
    double max_pitch_rad = 0.0;
    double max_rate_radps = 0.0;
    PitchGainSchedule gains;
  };
  using State = LimitedPi;

  PitchControl(Params params, double time_step_s)
      : params_(std::move(params)), time_step_s_(time_step_s) {}

  /// Starts at the measured pitch. Below rated, the blades at the fine pitch and the speed short,
  /// the integrator starts at the fine pitch and not where it would hold against the error.
  void start(double speed_radps, double pitch_rad, State& state) const noexcept;

  /// `pitch_rad` is the measured angle that schedules the gains.
  double step(double speed_radps, double set_point_shift_radps, double pitch_rad,
              double feedforward_rate_radps, State& state) const noexcept;

  /// Whether the blades are further out than at work below rated.
  bool is_pitching(double pitch_rad) const noexcept;

 private:
  LimitedPi::Limits limits() const noexcept {
    return {params_.fine_pitch_rad, params_.max_pitch_rad, params_.max_rate_radps};
  }

  Params params_;
  double time_step_s_;
};

}  // namespace lac
