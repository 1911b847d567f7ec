// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/state_archive.hpp"

namespace lac {

struct PowerLevelParams {
  double rated_intensity = 0.16;  // TI_rated: level 1 (S20 section 4.2)
  double zero_intensity = 0.32;   // TI_0: level 0
  double maximum = 1.1;           // g_max
  // Fastest change of the level [1/s]. 0.005: 25 kW/s at 5 MW, and 20 s from 1 to 1.1 or 0.9.
  // S20 has none; without it the level would jump when the first estimate comes.
  double rate_1ps = 0.005;
};

/// S20 eq. 9: the share of rated power for a turbulence intensity, 0 ... maximum.
inline double power_level_for(double intensity, const PowerLevelParams& p) {
  const double g = (intensity - p.zero_intensity) / (p.rated_intensity - p.zero_intensity);
  return std::clamp(g, 0.0, p.maximum);
}

/// The level that is sent: starts at 1 and moves towards that of eq. 9, or back to 1 while the
/// intensity is unknown, never faster than the rate.
class PowerLevel {
 public:
  /// NaN: unknown.
  void set_intensity(double intensity, const PowerLevelParams& p) noexcept {
    known_ = std::isfinite(intensity);
    target_ = known_ ? power_level_for(intensity, p) : 1.0;
  }
  void step(double rate_1ps, double time_step_s) noexcept {
    const double most = rate_1ps * time_step_s;
    level_ += std::clamp(target_ - level_, -most, most);
  }
  double level() const { return level_; }
  /// False only when there is nothing to tell: intensity unknown and the level back at 1.
  bool valid() const { return known_ || level_ != 1.0; }
  void visit(StateArchive& a) { a(level_), a(target_), a(known_); }

 private:
  double level_ = 1.0;
  double target_ = 1.0;
  bool known_ = false;
};

}  // namespace lac
