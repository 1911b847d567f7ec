// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lac::sim {

enum class OperatingMode { kNotProducing, kBelowRated, kAboveRated, kMixed };

/// "not producing", "below rated", "above rated", "mixed".
const char* text_of(OperatingMode mode);

/// Where a pitch-regulated turbine is at one instant: above rated if its pitch is more than a
/// margin above fine pitch, else below rated; not producing if its power is at most a share of the
/// rated.
struct ModeRule {
  double rated_power = 0.0;  // all powers and angles in the units of the series
  double fine_pitch = 0.0;
  double pitch_margin = 1.0;
  double least_power_share = 0.01;
  double least_share = 0.95;  // of a window's samples that must agree; else it is mixed

  OperatingMode at(double power, double pitch) const;
  /// Of a window. Throws lac::Error if the lengths differ or are 0.
  OperatingMode of(std::span<const double> power, std::span<const double> pitch) const;
};

struct Stretch {
  std::size_t first = 0;
  std::size_t length = 0;
};

/// The longest runs of samples in which every one is in this mode and x and y are finite, of at
/// least so many samples. All spans of one length.
std::vector<Stretch> stretches_in(OperatingMode mode, const ModeRule& rule,
                                  std::span<const double> power, std::span<const double> pitch,
                                  std::span<const double> x, std::span<const double> y,
                                  std::size_t least_samples);

}  // namespace lac::sim
