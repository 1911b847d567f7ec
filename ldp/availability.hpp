// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "core/filters.hpp"

namespace lac {

/// Share of the samples of a lidar that can be used, slow mean. What should come, one measurement
/// per beam and scan, counts whether it comes or not: a silent lidar has none.
class Availability {
 public:
  struct Params {
    int beams = 4;
    double scan_time_s = 1.0;
    double window_s = 60.0;
  };

  /// Usable share of one measurement.
  void count(double share) noexcept { in_scan_ += share; }
  /// Every step.
  void advance(double time_s, const Params& p) noexcept {
    if (time_s < scan_end_s_) return;
    if (scan_end_s_ > 0.0) mean_.add(in_scan_ / p.beams, p.scan_time_s, p.window_s);
    in_scan_ = 0.0;
    scan_end_s_ = std::max(scan_end_s_, time_s - p.scan_time_s) + p.scan_time_s;
  }
  /// 0 to 1; not a number before the first scan.
  double value() const noexcept {
    return mean_.started() ? std::min(mean_.mean(), 1.0) : std::numeric_limits<double>::quiet_NaN();
  }
  void visit(StateArchive& a) { a(mean_), a(in_scan_), a(scan_end_s_); }

 private:
  SlowMean mean_;
  double in_scan_ = 0.0;
  double scan_end_s_ = 0.0;
};

}  // namespace lac
