// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/time_axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace lac::sim {
namespace {

constexpr double kMostUneven = 0.25;  // of a step
constexpr double kMostRounding = 0.49;
constexpr double kFewestRounded = 0.1;  // of all steps: fewer are gaps
constexpr std::size_t kFewestTimes = 100;
constexpr double kStepPrecision = 1e-9;

std::string text_of(double seconds) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g s", seconds);
  return text;
}

/// 0.0125 for 0.012500000000000001: what nine digits say, if they say the same.
double tidy(double step_s) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", step_s);
  const double short_s = std::strtod(text, nullptr);
  return std::abs(short_s - step_s) < kStepPrecision * step_s ? short_s : step_s;
}

double median_step(std::span<const double> times_s) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) steps_s.push_back(times_s[i] - times_s[i - 1]);
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  return *middle;
}

std::size_t uneven_steps(std::span<const double> times_s, double step_s) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < times_s.size(); ++i)
    if (std::abs(times_s[i] - times_s[i - 1] - step_s) > kMostUneven * step_s) ++count;
  return count;
}

bool on_a_line(std::span<const double> times_s, double step_s) {
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const double line_s = times_s[0] + static_cast<double>(i) * step_s;
    if (std::abs(times_s[i] - line_s) >= kMostRounding * step_s) return false;
  }
  return true;
}

/// Written with so few digits that steps differ a lot, here a bit and there a bit.
bool coarsely_rounded(std::span<const double> times_s, double mean_s, std::size_t uneven) {
  return times_s.size() >= kFewestTimes &&
         static_cast<double>(uneven) >= kFewestRounded * static_cast<double>(times_s.size()) &&
         on_a_line(times_s, mean_s);
}

}  // namespace

TimeAxis time_axis_of(
    std::span<const double> times_s,
    const std::function<void(std::size_t row, const std::string& problem)>& fail) {
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (!std::isfinite(times_s[i])) fail(i, "the time is not a finite number");
    if (i > 0 && !(times_s[i] > times_s[i - 1])) {
      fail(i,
           "found time " + text_of(times_s[i]) + ", expected one after " + text_of(times_s[i - 1]));
    }
  }
  if (times_s.empty()) return {0.0, 1.0, {}};
  if (times_s.size() == 1) return {times_s[0], 1.0, {}};
  const double mean_s =
      (times_s.back() - times_s.front()) / static_cast<double>(times_s.size() - 1);
  const double median_s = median_step(times_s);
  const std::size_t uneven = uneven_steps(times_s, median_s);
  if (uneven == 0 || coarsely_rounded(times_s, mean_s, uneven))
    return {times_s[0], tidy(mean_s), {}};

  TimeAxis axis{times_s[0], 0.0, {0}};
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const double steps = (times_s[i] - times_s[i - 1]) / median_s;
    const double whole = std::round(steps);
    if (whole < 1.0 || std::abs(steps - whole) > kMostUneven) {
      fail(i, "found a step of " + text_of(times_s[i] - times_s[i - 1]) +
                  ", expected a whole number of the usual step of " + text_of(median_s));
    }
    axis.place.push_back(axis.place.back() + static_cast<std::size_t>(whole));
  }
  axis.step_s = tidy((times_s.back() - times_s.front()) / static_cast<double>(axis.place.back()));
  return axis;
}

}  // namespace lac::sim
