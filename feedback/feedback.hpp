// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "feedback/feedback_params.hpp"

namespace lac {

/// Generator torque and collective pitch of one turbine from its generator speed: speed filter,
/// set-point fading, torque loop, pitch loop with feedforward rate, optional actuator model.
///
/// The first good step starts it without a bump: demands at the measured pitch and at the torque
/// measured or, while the host says zero, at the one of the operating point. A step with inputs
/// that are not good changes nothing: the demands hold, and go on from there within the rates;
/// before the start they are the measured pitch, or the fine pitch if that is no number, and no
/// torque.
class Feedback {
 public:
  struct Inputs {
    double generator_speed_radps = 0.0;
    double pitch_rad = 0.0;
    double generator_torque_Nm = 0.0;  // read at the start only; 0: the host has none yet
    double feedforward_rate_radps = 0.0;
    std::optional<double> power_level = std::nullopt;  // none: g = 1
    bool good = true;  // false: the master knows that a measurement is not usable
  };
  struct Outputs {
    double pitch_rad = 0.0;
    double torque_Nm = 0.0;
    double speed_filtered_radps = 0.0;
    double pitch_integral_rad = 0.0;
    double set_point_shift_radps = 0.0;
    TorqueRegion region = TorqueRegion::Off;
  };
  /// What happened in a step, for one message each.
  struct Events {
    bool hold_began = false;
    int recovered_after_steps = 0;
    bool feedforward_lost = false;  // the rate became not finite; it counts as zero
    bool power_level_lost = false;  // not in [0, MaximumPowerLevel] any more; it counts as none
  };
  struct State {
    bool started = false;
    int held_steps = 0;
    bool feedforward_bad = false;
    bool power_level_bad = false;
    double power_level = 1.0;  // g in use, moved by PowerLevelRate
    SpeedFilter::State speed;
    SetPointFading::State fading;
    TorqueControl::State torque;
    PitchControl::State pitch;
    PitchActuator::State actuator;
    Outputs last;
    void visit(StateArchive& a);
  };

  /// Throws Error when the time step is too long for the filters.
  Feedback(const FeedbackParams& params, double time_step_s);

  /// Advances by one time step.
  Outputs step(const Inputs& in, State& state, Events& events) const noexcept;

 private:
  Outputs hold(const Inputs& in, State& state, Events& events) const noexcept;
  void start(const Inputs& in, State& state) const noexcept;
  void advance(const Inputs& in, State& state, Events& events) const noexcept;
  void move_power_level(std::optional<double> wanted, State& state, Events& events) const noexcept;
  double feedforward_rate(double given_radps, State& state, Events& events) const noexcept;
  double shift(double pitch_rad, State& state) const noexcept;

  FeedbackParams params_;
  double time_step_s_;
  SpeedFilter speed_filter_;
  SetPointFading fading_;
  TorqueControl torque_;
  PitchControl pitch_;
  std::optional<PitchActuator> actuator_;
};

}  // namespace lac
