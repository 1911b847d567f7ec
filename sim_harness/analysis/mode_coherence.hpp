// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "sim_harness/analysis/coherence.hpp"
#include "sim_harness/analysis/coherence_decay.hpp"
#include "sim_harness/analysis/inflow_windows.hpp"

namespace lac::sim {

/// Coherence of wind and load in one operating mode (G18 section 2.3), over all stretches in it.
struct ModeCoherence {
  CrossSpectrum spectrum;
  std::size_t blocks = 0;
  double speed_mps = 0.0;  // mean and standard deviation of the wind in these stretches
  double sigma_mps = 0.0;

  /// Where the coherence falls through a level, and the wavelength speed / frequency; NaN: never.
  double fall_hz(double level) const;
  /// Decay of eq. 4, over range / speed; all frequencies.
  DecayFit decay(double range_m) const;
  /// Decay of eq. 5, scaled with the turbulence intensity.
  DecayFit scaled_decay(double range_m) const;
};

/// The load is moved forward by delay_s (not below 0) first, so that a delay does not pass for
/// missing coherence. None if there are not two blocks.
std::optional<ModeCoherence> mode_coherence(const InflowSeries& series, OperatingMode mode,
                                            double delay_s, const ModeRule& rule, double block_s);

}  // namespace lac::sim
