// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/lookup_table.hpp"
#include "core/state_archive.hpp"

namespace lac {

struct PowerLevelParams {
  LookupTable rated_intensity{{0.0},
                              {0.16}};        // TI_rated over mean speed: level 1 (S20 section 4.2)
  LookupTable zero_intensity{{0.0}, {0.32}};  // TI_0 over mean speed: level 0
  double maximum = 1.1;                       // g_max
  double deadband = 0.0;  // the level stays where it is while eq. 9 is no farther away
  // Fastest change of the level [1/s]. 0.005: 25 kW/s at 5 MW, and 20 s from 1 to 1.1 or 0.9.
  // S20 has none; without it the level would jump when the first estimate comes.
  double rate_1ps = 0.005;
};

/// S20 eq. 9: the share of rated power for a turbulence intensity, 0 ... maximum.
inline double power_level_for(double intensity, double mean_speed_mps,
                              const PowerLevelParams& p) noexcept {
  const double zero = p.zero_intensity.at(mean_speed_mps);
  const double g = (intensity - zero) / (p.rated_intensity.at(mean_speed_mps) - zero);
  return std::clamp(g, 0.0, p.maximum);
}

/// The level that is sent: starts at 1 and moves towards that of eq. 9, or back to 1 while the
/// intensity is unknown, never faster than the rate.
class PowerLevel {
 public:
  /// NaN: unknown.
  void set_intensity(double intensity, double mean_speed_mps, const PowerLevelParams& p) noexcept {
    const bool was_known = known_;
    known_ = std::isfinite(intensity);
    const double target = known_ ? power_level_for(intensity, mean_speed_mps, p) : 1.0;
    if (!known_ || !was_known || std::abs(target - target_) > p.deadband) target_ = target;
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
