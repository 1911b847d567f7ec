// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/input_file.hpp"
#include "core/lookup_table.hpp"
#include "ffp/entry.hpp"

namespace lac {

struct FfpParams {
  // Cut-off of the low-pass over the slow mean wind speed: from the correlation of lidar and
  // rotor, about proportional to the wind speed (methods section 5).
  LookupTable cutoff_hz;
  // Order of the low-pass; of a second-order one cutoff_hz is the natural frequency and this the
  // damping, over the mean wind speed.
  int filter_order = 1;
  LookupTable damping;
  // The cut-off is multiplied with this, over the turbulence intensity; empty: with 1.
  LookupTable turbulence_factor;
  // Frequency at which filter and actuator delay are made up for: where the rotor speed spectrum
  // has its weight. HM: 0.0425 Hz; public 5 MW controllers: 0.08 Hz, 15 MW: 0.025 Hz.
  double delay_frequency_hz = 0.08;
  // Second-order pitch actuator; a frequency of 0 is an actuator without delay.
  double actuator_frequency_hz = 1.0;
  double actuator_damping = 0.7;
  // Added to the computed buffer time (tuning; positive acts later), over the mean wind speed.
  LookupTable buffer_trim_s{{0.0}, {0.0}};
  // A buffer tuned by hand in the place of the computed one; no gate is too near for it.
  std::optional<double> fixed_buffer_s;
  // The buffer follows its computed time as a first-order lag, so that a new mean wind speed makes
  // no pitch activity of its own.
  double buffer_time_constant_s = 10.0;
  double longest_buffer_s = 60.0;
  // Static pitch curve theta_ss(v): zero below rated, never falling.
  LookupTable static_pitch_rad;
  // The same at a power level below 1; in between by straight lines. Empty: the curve of rated
  // power counts for all levels.
  LookupTable reduced_pitch_rad;
  double reduced_power_level = 0.5;
  EntryRule entry = EntryRule::Threshold;
  // Active above this buffered wind speed, off again `hysteresis` below it: just above rated the
  // curve is too steep to act on (GUO: 14 m/s for the NREL 5 MW).
  double threshold_mps = 14.0;
  double hysteresis_mps = 0.5;
  // Blend: from nothing to all between these buffered wind speeds.
  double blend_from_mps = 12.0;
  double blend_to_mps = 15.0;
  // Slope: that of the curve is cut to this.
  double largest_slope_radpmps = 0.035;
  double fade_time_s = 2.0;
  // A demanded rate beyond this is cut, and the reason record says so.
  double max_rate_radps = 0.07;
  // Largest pitch that it adds, and how fast that is forgotten. None: no limit.
  std::optional<double> largest_pitch_rad;
  double largest_pitch_time_s = 20.0;
  // Take the buffer trim and the share of the rate that a live monitor of lidar and rotor allows.
  bool use_monitor = false;

  /// Reads all keys and refuses unknown ones. Throws lac::Error.
  static FfpParams read(InputFile& in);

  double largest_cutoff_hz() const;

  /// Refuses what makes no sense at this time step. Throws lac::Error with file, line and key.
  void check_time_step(const InputFile& in, double time_step_s) const;
};

}  // namespace lac
