// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/correlation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kFewestSamples = 4;

double mean_of(std::span<const double> series) {
  return std::accumulate(series.begin(), series.end(), 0.0) / static_cast<double>(series.size());
}

double coefficient(std::span<const double> x, std::span<const double> y) {
  const double mean_x = mean_of(x), mean_y = mean_of(y);
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] - mean_x, dy = y[i] - mean_y;
    xx += dx * dx;
    yy += dy * dy;
    xy += dx * dy;
  }
  return xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : kNotANumber;
}

/// Place of the turn of a parabola through three values, from the middle one, the extreme of the
/// three, in steps.
double turn_of(double before, double middle, double after) {
  const double bend = before - 2.0 * middle + after;
  return bend == 0.0 ? 0.0 : 0.5 * (before - after) / bend;
}

struct Lags {
  std::ptrdiff_t first = 0;
  std::vector<double> coefficients;
};

Lags coefficients_at(std::span<const double> x, std::span<const double> y, double time_step_s,
                     std::size_t first, std::size_t length, const LagRange& range) {
  const auto at = static_cast<std::ptrdiff_t>(first);
  const auto last_fit =
      static_cast<std::ptrdiff_t>(y.size()) - at - static_cast<std::ptrdiff_t>(length);
  const auto from =
      std::max(static_cast<std::ptrdiff_t>(std::ceil(range.min_s / time_step_s - 1e-9)), -at);
  const auto to =
      std::min(static_cast<std::ptrdiff_t>(std::floor(range.max_s / time_step_s + 1e-9)), last_fit);
  Lags lags{from, {}};
  for (std::ptrdiff_t lag = from; lag <= to; ++lag) {
    lags.coefficients.push_back(coefficient(x.subspan(first, length),
                                            y.subspan(static_cast<std::size_t>(at + lag), length)));
  }
  return lags;
}

}  // namespace

CorrelationPeak correlation_peak(std::span<const double> x, std::span<const double> y,
                                 double time_step_s, std::size_t first, std::size_t length,
                                 const LagRange& lags) {
  const auto [first_lag, c] = coefficients_at(x, y, time_step_s, first, length, lags);
  const bool usable =
      !c.empty() && std::ranges::all_of(c, [](double v) { return std::isfinite(v); });
  if (!usable) return {kNotANumber, kNotANumber, false};
  const auto height = [&](double v) { return lags.sign == PeakSign::kEither ? std::abs(v) : v; };
  const auto best = static_cast<std::size_t>(std::ranges::max_element(c, {}, height) - c.begin());
  const double lag = static_cast<double>(first_lag) + static_cast<double>(best);
  if (best == 0 || best + 1 == c.size()) return {c[best], lag * time_step_s, true};
  const double off = turn_of(c[best - 1], c[best], c[best + 1]);
  const double top = c[best] - 0.25 * (c[best - 1] - c[best + 1]) * off;
  return {std::clamp(top, -1.0, 1.0), (lag + off) * time_step_s, false};
}

std::vector<WindowPlace> moving_windows(std::size_t samples, double time_step_s,
                                        const MovingWindow& window) {
  const auto length = static_cast<std::size_t>(std::lround(window.length_s / time_step_s));
  if (length < kFewestSamples || !(window.overlap >= 0.0 && window.overlap < 1.0)) {
    throw Error("moving window: " + std::to_string(window.length_s) + " s with an overlap of " +
                std::to_string(window.overlap) +
                ", expected at least 4 samples and an overlap from 0 to below 1");
  }
  const double stride = (1.0 - window.overlap) * static_cast<double>(length);
  const auto step = std::max<std::size_t>(static_cast<std::size_t>(std::lround(stride)), 1);
  std::vector<WindowPlace> windows;
  for (std::size_t first = 0; first + length <= samples; first += step)
    windows.push_back({first, length});
  return windows;
}

std::vector<double> block_means(std::span<const double> series, std::size_t count) {
  std::vector<double> means;
  for (std::size_t i = 0; i + count <= series.size(); i += count)
    means.push_back(mean_of(series.subspan(i, count)));
  return means;
}

double integral_time_scale(std::span<const double> series, double time_step_s) {
  if (series.size() < kFewestSamples) return kNotANumber;
  const double mean = mean_of(series);
  const auto covariance = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < series.size(); ++i)
      sum += (series[i] - mean) * (series[i + lag] - mean);
    return sum / static_cast<double>(series.size() - lag);
  };
  const double variance = covariance(0);
  if (!(variance > 0.0)) return kNotANumber;
  double area = 0.0, before = 1.0;
  for (std::size_t lag = 1; lag < series.size(); ++lag) {
    const double now = covariance(lag) / variance;
    if (now <= 0.0) return (area + 0.5 * before * before / (before - now)) * time_step_s;
    area += 0.5 * (before + now);
    before = now;
  }
  return kNotANumber;
}

}  // namespace lac::sim
