// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/input_file.hpp"
#include "core/lookup_table.hpp"

namespace lac {

struct FfpParams {
  // Cut-off of the low-pass over the slow mean wind speed: from the correlation of lidar and
  // rotor, about proportional to the wind speed (methods section 5).
  LookupTable cutoff_hz;
  // Frequency at which filter and actuator delay are made up for: where the rotor speed spectrum
  // has its weight. HM: 0.0425 Hz; public 5 MW controllers: 0.08 Hz, 15 MW: 0.025 Hz.
  double delay_frequency_hz = 0.08;
  // Second-order pitch actuator; a frequency of 0 is an actuator without delay.
  double actuator_frequency_hz = 1.0;
  double actuator_damping = 0.7;
  // Added to the computed buffer time (tuning; positive acts later).
  double buffer_trim_s = 0.0;
  // The buffer follows its computed time as a first-order lag, so that a new mean wind speed makes
  // no pitch activity of its own.
  double buffer_time_constant_s = 10.0;
  double longest_buffer_s = 60.0;
  // Static pitch curve theta_ss(v): zero below rated, never falling.
  LookupTable static_pitch_rad;
  // Active above this buffered wind speed, off again `hysteresis` below it: just above rated the
  // curve is too steep to act on (GUO: 14 m/s for the NREL 5 MW).
  double threshold_mps = 14.0;
  double hysteresis_mps = 0.5;
  double fade_time_s = 2.0;
  // A demanded rate beyond this is cut, and the reason record says so.
  double max_rate_radps = 0.07;
  // Take the buffer trim and the share of the rate that a live monitor of lidar and rotor allows.
  bool use_monitor = false;

  /// Reads all keys and refuses unknown ones. Throws lac::Error.
  static FfpParams read(InputFile& in);

  /// Refuses what makes no sense at this time step. Throws lac::Error with file, line and key.
  void check_time_step(const InputFile& in, double time_step_s) const;
};

}  // namespace lac
