// SPDX-License-Identifier: Apache-2.0
// What of a measured series can be used: limits, stuck values, gaps (G18 section 2.1).
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace lac::sim {

struct QualityRule {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  /// Values that stay the same for longer than this are no measurements.
  double stuck_s = std::numeric_limits<double>::infinity();
  /// Gaps up to this length, with good samples on both sides, are filled linearly.
  double fill_s = 0.0;
};

/// Each bad sample counts once, for the first reason that applies in this order.
struct QualityCount {
  std::size_t samples = 0;
  std::size_t missing = 0;  // not finite in the first place
  std::size_t outside = 0;  // of the limits
  std::size_t stuck = 0;
  std::size_t gaps_filled = 0;
  std::size_t filled = 0;  // samples
  std::size_t gaps_left = 0;
  std::size_t left = 0;  // samples without a value

  /// Share of good samples before filling.
  double availability() const;
  /// "18000 samples: 12 missing, 3 outside -5 ... 35, ...; 4 gaps (15 samples) filled linearly,
  /// ..."
  std::string text() const;
};

/// Makes bad samples NaN, then fills short gaps. A sample stands for one time step: a gap of n
/// samples is n steps long; values are stuck if n + 1 equal ones span more than stuck_s.
QualityCount clean(std::vector<double>& series, double time_step_s, const QualityRule& rule);

/// Makes samples NaN whose companion (the CNR of a lidar) is not from min to max or not finite.
/// Returns how many were made so. Throws lac::Error if the lengths differ.
std::size_t drop_by_companion(std::vector<double>& series, std::span<const double> companion,
                              double min, double max);

}  // namespace lac::sim
