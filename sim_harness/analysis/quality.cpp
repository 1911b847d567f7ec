// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/quality.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 1e-9;

void drop_outside(std::vector<double>& series, const QualityRule& rule, QualityCount& count) {
  for (double& x : series) {
    if (!std::isfinite(x)) {
      ++count.missing;
      x = kNotANumber;
    } else if (x < rule.min || x > rule.max) {
      ++count.outside;
      x = kNotANumber;
    }
  }
}

void drop_stuck(std::vector<double>& series, double time_step_s, double stuck_s,
                QualityCount& count) {
  for (std::size_t first = 0; first < series.size();) {
    std::size_t end = first + 1;
    while (end < series.size() && series[end] == series[first]) ++end;
    if (static_cast<double>(end - first - 1) * time_step_s > stuck_s + kRounding) {
      count.stuck += end - first;
      for (std::size_t i = first; i < end; ++i) series[i] = kNotANumber;
    }
    first = end;
  }
}

void fill_gaps(std::vector<double>& series, double time_step_s, double fill_s,
               QualityCount& count) {
  for (std::size_t first = 0; first < series.size();) {
    if (!std::isnan(series[first])) {
      ++first;
      continue;
    }
    std::size_t end = first;
    while (end < series.size() && std::isnan(series[end])) ++end;
    const std::size_t length = end - first;
    const bool short_enough = static_cast<double>(length) * time_step_s <= fill_s + kRounding;
    if (short_enough && first > 0 && end < series.size()) {
      const double from = series[first - 1];
      const double step = (series[end] - from) / static_cast<double>(length + 1);
      for (std::size_t i = first; i < end; ++i)
        series[i] = from + step * static_cast<double>(i - first + 1);
      ++count.gaps_filled;
      count.filled += length;
    } else {
      ++count.gaps_left;
      count.left += length;
    }
    first = end;
  }
}

}  // namespace

double QualityCount::availability() const {
  if (samples == 0) return 0.0;
  return 1.0 - static_cast<double>(missing + outside + stuck) / static_cast<double>(samples);
}

std::string QualityCount::text() const {
  const auto number = [](std::size_t n) { return std::to_string(n); };
  return number(samples) + " samples: " + number(missing) + " missing, " + number(outside) +
         " outside the limits, " + number(stuck) + " stuck; " + number(gaps_filled) + " gaps (" +
         number(filled) + " samples) filled linearly, " + number(gaps_left) + " (" + number(left) +
         " samples) left";
}

QualityCount clean(std::vector<double>& series, double time_step_s, const QualityRule& rule) {
  QualityCount count;
  count.samples = series.size();
  drop_outside(series, rule, count);
  drop_stuck(series, time_step_s, rule.stuck_s, count);
  fill_gaps(series, time_step_s, rule.fill_s, count);
  return count;
}

std::size_t drop_by_companion(std::vector<double>& series, std::span<const double> companion,
                              double min, double max) {
  if (companion.size() != series.size()) {
    throw Error("quality: " + std::to_string(series.size()) + " samples with " +
                std::to_string(companion.size()) + " of their companion, expected as many");
  }
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (std::isnan(series[i]) || (companion[i] >= min && companion[i] <= max)) continue;
    series[i] = kNotANumber;
    ++dropped;
  }
  return dropped;
}

}  // namespace lac::sim
