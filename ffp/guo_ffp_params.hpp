// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guo_input_file.hpp"
#include "core/lookup_table.hpp"
#include "core/units.hpp"

namespace lac {

/// What an FFP input file of Guo's chain says.
struct GuoFfpParams {
  bool version_2 = false;  // FFP_v2: with a notch
  bool low_pass = false;   // FlagLPF
  double cutoff_radps = 0.0;
  // FlagNotch: (s^2 + 2 w num s + w^2)/(s^2 + 2 w den s + w^2)
  bool notch = false;
  double notch_radps = 0.0;
  double notch_num = 0.0;
  double notch_den = 0.0;
  double buffer_s = 0.0;         // T_buffer: fixed, no lead is looked at
  LookupTable static_pitch_rad;  // over wind speed [m/s]; held constant outside of its points
  // All values as their library would give them, its defects included; for comparison.
  bool legacy_timing = false;

  double cutoff_hz() const { return cutoff_radps / radps_from_hz(1.0); }
  double notch_hz() const { return notch_radps / radps_from_hz(1.0); }

  static GuoForm form_of(const GuoInputFile& file);
  /// Precondition: file.is_theirs(guo_ffp_marks()). Throws lac::Error with file and line, also for
  /// a filter beyond half the rate of calls.
  static GuoFfpParams read(const GuoInputFile& file, double time_step_s);
};

}  // namespace lac
