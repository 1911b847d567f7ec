// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace lac::sim {

Statistics statistics(std::span<const double> series, std::size_t first_sample) {
  if (series.size() < first_sample + 2) {
    throw Error("statistics need at least two samples: the series has " +
                std::to_string(series.size()) + ", of which the first " +
                std::to_string(first_sample) + " are discarded");
  }
  const auto used = series.subspan(first_sample);
  const auto first = static_cast<std::ptrdiff_t>(first_sample);
  const auto count = static_cast<double>(used.size());
  double sum = 0.0;
  for (const double x : used) sum += x;
  const double mean = sum / count;
  double squares = 0.0;
  for (const double x : used) squares += (x - mean) * (x - mean);
  const double deviation = std::sqrt(squares / (count - 1.0));
  if (std::isnan(mean)) return {mean, deviation, mean, mean};
  const auto min = std::min_element(series.begin() + first, series.end());
  const auto max = std::max_element(series.begin() + first, series.end());
  return {mean,
          deviation,
          *min,
          *max,
          static_cast<std::size_t>(min - series.begin()),
          static_cast<std::size_t>(max - series.begin())};
}

double travel(std::span<const double> series) {
  double sum = 0.0;
  for (std::size_t i = 1; i < series.size(); ++i) sum += std::abs(series[i] - series[i - 1]);
  return sum;
}

}  // namespace lac::sim
