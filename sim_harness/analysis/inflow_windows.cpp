// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/inflow_windows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "core/error.hpp"
#include "sim_harness/analysis/statistics.hpp"

namespace lac::sim {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

void require_equal_lengths(const InflowSeries& s) {
  const std::size_t n = s.wind.size();
  if (s.load.size() == n && s.power.size() == n && s.pitch.size() == n) return;
  throw Error("correlation: series of " + std::to_string(n) + ", " + std::to_string(s.load.size()) +
              ", " + std::to_string(s.power.size()) + " and " + std::to_string(s.pitch.size()) +
              " samples, expected equal lengths");
}

double quantile(const std::vector<double>& sorted, double probability) {
  const double place = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 == sorted.size()) return sorted.back();
  const double part = place - static_cast<double>(below);
  return sorted[below] + part * (sorted[below + 1] - sorted[below]);
}

}  // namespace

InflowWindows inflow_windows(const InflowSeries& s, const MovingWindow& window,
                             const LagRange& lags, const ModeRule& rule) {
  require_equal_lengths(s);
  InflowWindows result;
  for (const WindowPlace& place : moving_windows(s.wind.size(), s.time_step_s, window)) {
    const auto part = [&](const std::vector<double>& all) {
      return std::span(all).subspan(place.first, place.length);
    };
    InflowWindow w;
    w.peak = correlation_peak(s.wind, s.load, s.time_step_s, place.first, place.length, lags);
    const double last_s = static_cast<double>(place.first + place.length) * s.time_step_s;
    const bool cut =
        last_s + lags.max_s > static_cast<double>(s.load.size()) * s.time_step_s + 1e-9;
    if (cut || !std::isfinite(w.peak.correlation)) {
      ++result.incomplete;
      continue;
    }
    const Statistics wind = statistics(part(s.wind));
    w.start_s = s.start_s + static_cast<double>(place.first) * s.time_step_s;
    w.speed_mps = wind.mean;
    w.intensity = wind.standard_deviation / wind.mean;
    w.mode = rule.of(part(s.power), part(s.pitch));
    w.time_scale_s = integral_time_scale(part(s.wind), s.time_step_s);
    w.length_scale_m = w.time_scale_s * wind.mean;
    result.windows.push_back(w);
  }
  return result;
}

Typical typical(std::span<const double> values, double bin_width) {
  std::vector<double> sorted;
  std::ranges::copy_if(values, std::back_inserter(sorted),
                       [](double v) { return std::isfinite(v); });
  if (sorted.empty())
    return {kNotANumber, kNotANumber, kNotANumber, kNotANumber, kNotANumber, kNotANumber};
  std::ranges::sort(sorted);
  std::map<long, std::size_t> bins;
  for (const double v : sorted) ++bins[std::lround(std::floor(v / bin_width))];
  const auto fullest = std::ranges::max_element(
      bins, [](const auto& a, const auto& b) { return a.second < b.second; });
  const double from = static_cast<double>(fullest->first) * bin_width;
  return {quantile(sorted, 0.25),
          quantile(sorted, 0.5),
          quantile(sorted, 0.75),
          from,
          from + bin_width,
          static_cast<double>(fullest->second) / static_cast<double>(sorted.size())};
}

}  // namespace lac::sim
