// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace lac::sim {

/// In the unit of the series. A NaN in the series makes the four values NaN.
struct Statistics {
  double mean = 0.0;
  double standard_deviation = 0.0;  // with n - 1
  double min = 0.0;
  double max = 0.0;
  std::size_t min_sample = 0;  // where they are in the series, the first if several
  std::size_t max_sample = 0;
};

/// Of the samples from first_sample on (the run-in before it is discarded). Throws lac::Error
/// if fewer than two samples are left.
Statistics statistics(std::span<const double> series, std::size_t first_sample = 0);

/// The way that was travelled: sum of the absolute differences of neighbours, in the unit of the
/// series. For pitch travel.
double travel(std::span<const double> series);

}  // namespace lac::sim
