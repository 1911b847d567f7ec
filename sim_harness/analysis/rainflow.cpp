// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/rainflow.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kTwentyYears_s = 20.0 * 8760.0 * 3600.0;

LoadCycle cycle(double from, double to, double count) {
  return {std::abs(to - from), 0.5 * (from + to), count};
}

void require_finite(std::span<const double> series) {
  const auto bad =
      std::find_if_not(series.begin(), series.end(), [](double x) { return std::isfinite(x); });
  if (bad == series.end()) return;
  throw Error("rainflow counting: sample " + std::to_string(bad - series.begin()) + " of " +
              std::to_string(series.size()) + " is not a finite number");
}

std::vector<LoadCycle> three_point_cycles(std::span<const double> points) {
  std::vector<LoadCycle> cycles;
  std::vector<double> open;
  std::size_t start = 0;  // open[start] is where the remaining history begins
  for (const double point : points) {
    open.push_back(point);
    while (open.size() - start >= 3) {
      const std::size_t n = open.size();
      const double latest = std::abs(open[n - 1] - open[n - 2]);
      const double before = std::abs(open[n - 2] - open[n - 3]);
      if (latest < before) break;
      if (n - start == 3) {
        cycles.push_back(cycle(open[start], open[start + 1], 0.5));
        ++start;
      } else {
        cycles.push_back(cycle(open[n - 3], open[n - 2], 1.0));
        open.erase(open.end() - 3, open.end() - 1);
      }
    }
  }
  for (; start + 1 < open.size(); ++start) {
    cycles.push_back(cycle(open[start], open[start + 1], 0.5));
  }
  return cycles;
}

/// Moves closed cycles out of the points; what is returned never closes.
std::vector<double> close_cycles(std::span<const double> points, std::vector<LoadCycle>& cycles) {
  std::vector<double> open;
  for (const double point : points) {
    open.push_back(point);
    while (open.size() >= 4) {
      const std::size_t n = open.size();
      const double before = std::abs(open[n - 3] - open[n - 4]);
      const double inner = std::abs(open[n - 2] - open[n - 3]);
      const double latest = std::abs(open[n - 1] - open[n - 2]);
      if (inner > before || inner > latest) break;
      cycles.push_back(cycle(open[n - 3], open[n - 2], 1.0));
      open.erase(open.end() - 3, open.end() - 1);
    }
  }
  return open;
}

std::vector<LoadCycle> four_point_cycles(std::span<const double> points) {
  std::vector<LoadCycle> cycles;
  std::vector<double> twice = close_cycles(points, cycles);
  const std::vector<double> residue = twice;
  twice.insert(twice.end(), residue.begin(), residue.end());
  close_cycles(turning_points(twice), cycles);
  return cycles;
}

const char* text_of(RainflowRule rule) {
  return rule == RainflowRule::kAstm
             ? "rainflow counting after ASTM E1049, residue as half cycles, no binning"
             : "four-point rainflow counting, residue repeated and closed, no binning";
}

}  // namespace

std::vector<double> turning_points(std::span<const double> series) {
  std::vector<double> points;
  for (const double x : series) {
    const std::size_t n = points.size();
    if (n > 0 && x == points[n - 1]) continue;
    const bool goes_on = n > 1 && (points[n - 1] > points[n - 2]) == (x > points[n - 1]);
    if (goes_on) {
      points[n - 1] = x;
    } else {
      points.push_back(x);
    }
  }
  return points;
}

std::vector<LoadCycle> rainflow(std::span<const double> series, RainflowRule rule) {
  require_finite(series);
  const std::vector<double> points = turning_points(series);
  return rule == RainflowRule::kAstm ? three_point_cycles(points) : four_point_cycles(points);
}

double DelConvention::reference_cycles(double duration_s) const {
  return reference == ReferenceCycles::kOneHertz ? duration_s : 2e6 * duration_s / kTwentyYears_s;
}

std::string DelRule::text() const {
  const std::string cycles = reference == ReferenceCycles::kOneHertz
                                 ? "one cycle per second (N_ref = T)"
                                 : "2e6 cycles in 20 years (N_ref = 2e6 T / 20 years)";
  return "R the full range, reference " + cycles + "; " + text_of(counting);
}

const char* word_of(ReferenceCycles reference) {
  return reference == ReferenceCycles::kOneHertz ? "1hz" : "2e6in20y";
}

const char* word_of(RainflowRule rule) {
  return rule == RainflowRule::kAstm ? "astm" : "four-point";
}

std::optional<DelRule> del_rule_of(const std::string& reference, const std::string& counting) {
  for (const auto r : {ReferenceCycles::kOneHertz, ReferenceCycles::kTwoMillionInTwentyYears}) {
    for (const auto c : {RainflowRule::kAstm, RainflowRule::kFourPoint})
      if (reference == word_of(r) && counting == word_of(c)) return DelRule{r, c};
  }
  return std::nullopt;
}

std::string DelConvention::text() const {
  char exponent[32];
  std::snprintf(exponent, sizeof exponent, "%g", woehler_exponent);
  return "(sum n_i R_i^m / N_ref)^(1/m) with m = " + std::string(exponent) + ", " +
         DelRule{reference, counting}.text();
}

double damage_equivalent_load(std::span<const LoadCycle> cycles, double duration_s,
                              const DelConvention& convention) {
  const double m = convention.woehler_exponent;
  double damage = 0.0;
  for (const LoadCycle& c : cycles) damage += c.count * std::pow(c.range, m);
  return std::pow(damage / convention.reference_cycles(duration_s), 1.0 / m);
}

double damage_equivalent_load(std::span<const double> series, double time_step_s,
                              const DelConvention& convention) {
  const auto duration_s = static_cast<double>(series.size()) * time_step_s;
  return damage_equivalent_load(rainflow(series, convention.counting), duration_s, convention);
}

}  // namespace lac::sim
