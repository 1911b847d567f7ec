// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/input_file.hpp"
#include "feedback/gain_design.hpp"
#include "feedback/pitch_actuator.hpp"
#include "feedback/pitch_control.hpp"
#include "feedback/set_point_fading.hpp"
#include "feedback/speed_filter.hpp"
#include "feedback/torque_control.hpp"

namespace lac {

/// All the feedback controller needs, in SI units; the keys of the input file, their units and
/// defaults stand in README.md. Gains are there, whether given or designed.
struct FeedbackParams {
  SpeedFilter::Params speed;
  TorqueControl::Params torque;
  PitchControl::Params pitch;
  SetPointFading::Params fading;
  bool use_actuator = false;
  PitchActuator::Params actuator;
  bool use_feedforward = false;
  bool use_power_level = false;
  double max_power_level = 1.1;          // S20: g_max
  double power_level_rate_per_s = 0.01;  // a change of power set point without a jump of torque

  /// Reads the file to its end and designs the gains from the rotor table if it says so. Throws
  /// Error with file, line, key, what was found and what was expected.
  static FeedbackParams read(InputFile& in);

  /// Throws Error with file, line and key when the time step is too long for a filter.
  void check_time_step(const InputFile& in, double time_step_s) const;
};

}  // namespace lac
