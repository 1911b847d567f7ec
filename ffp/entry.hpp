// SPDX-License-Identifier: Apache-2.0
// Where the feedforward begins to act above rated wind speed. The static pitch curve is steepest
// there, and below rated the pitch does not follow it.
#pragma once

#include <algorithm>

#include "core/lookup_table.hpp"
#include "core/units.hpp"

namespace lac {

enum class EntryRule {
  Threshold,  // on or off, with hysteresis, faded over time (GUO: 14 m/s)
  Blend,      // rate times a smooth weight of the wind speed
  Slope,      // rate with the slope of the curve cut to a largest one
};

/// 3 x^2 - 2 x^3 of the place between the two speeds: 0 below, 1 above, no kink.
inline double blend_weight(double wind_mps, double from_mps, double to_mps) noexcept {
  const double x = std::clamp((wind_mps - from_mps) / (to_mps - from_mps), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// Cuts a slope of the pitch curve to `largest` [rad/(m/s)]. 0 where the curve is flat.
inline double slope_weight(double slope, double largest) noexcept {
  return slope > 0.0 ? std::min(1.0, largest / slope) : 0.0;
}

}  // namespace lac
