// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lac::sim {

/// Equidistant times, as a Recording needs them.
struct TimeAxis {
  double start_s = 0.0;
  double step_s = 0.0;
  std::vector<std::size_t> place;  // of each row on the axis; empty: no row is missing

  bool has_gaps() const { return !place.empty(); }
};

/// The axis of times as files have them. Steps may differ from their median by a quarter of it:
/// then no row is missing and the step is the mean. They may differ more where rounding to few
/// digits does it: at least 100 times, a tenth of the steps uneven, each time less than half a step
/// off a straight line. Otherwise rows are missing, and each step is a whole number of the median,
/// to a quarter of it. A single time has the step 1 s. fail(row, problem) must throw: a time that
/// is not finite or not after the one before, or a step that is none of these.
TimeAxis time_axis_of(std::span<const double> times_s,
                      const std::function<void(std::size_t row, const std::string& problem)>& fail);

}  // namespace lac::sim
