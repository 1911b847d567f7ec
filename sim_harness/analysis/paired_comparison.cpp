// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/paired_comparison.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "sim_harness/analysis/quantiles.hpp"
#include "sim_harness/analysis/statistics.hpp"

namespace lac::sim {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

double student_factor(double confidence, double degrees_of_freedom) {
  return student_quantile(0.5 * (1.0 + confidence), degrees_of_freedom);
}

void set_interval(PairedDifference& d, double half_width) {
  d.low = d.difference() - half_width;
  d.high = d.difference() + half_width;
}

}  // namespace

double PairedDifference::relative_change() const {
  return difference() / std::abs(mean_a);
}

double PairedDifference::relative_low() const {
  return low / std::abs(mean_a);
}

double PairedDifference::relative_high() const {
  return high / std::abs(mean_a);
}

std::string PairedDifference::verdict() const {
  if (!has_interval()) return pairs == 1 ? "one pair: no interval" : "no interval";
  if (significant()) return "significant";
  char text[48];
  std::snprintf(text, sizeof text, "not significant at %g %%", 100.0 * confidence);
  return text;
}

PairedDifference compare_pairs(std::span<const double> a, std::span<const double> b,
                               double confidence) {
  if (a.size() != b.size() || a.empty()) {
    throw Error("comparison: " + std::to_string(a.size()) + " values against " +
                std::to_string(b.size()) + ", expected pairs");
  }
  PairedDifference d{a.size(), 0.0, 0.0, kNotANumber, kNotANumber, confidence};
  const auto n = static_cast<double>(a.size());
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) {
    d.mean_a += a[i] / n;
    d.mean_b += b[i] / n;
    differences.push_back(b[i] - a[i]);
  }
  if (a.size() < 2) return d;
  const double deviation = statistics(differences).standard_deviation;
  set_interval(d, student_factor(confidence, n - 1.0) * deviation / std::sqrt(n));
  return d;
}

PairedDifference weighted_sum(std::span<const PairedDifference> parts,
                              std::span<const double> weights) {
  PairedDifference sum{0,           0.0,         0.0,
                       kNotANumber, kNotANumber, parts.empty() ? 0.95 : parts[0].confidence};
  double variance = 0.0, squares_over_degrees = 0.0;
  bool complete = !parts.empty();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PairedDifference& p = parts[i];
    sum.pairs += p.pairs;
    sum.mean_a += weights[i] * p.mean_a;
    sum.mean_b += weights[i] * p.mean_b;
    complete = complete && p.has_interval();
    if (!complete) continue;
    const double degrees = static_cast<double>(p.pairs) - 1.0;
    const double error = 0.5 * (p.high - p.low) / student_factor(p.confidence, degrees);
    const double part = weights[i] * weights[i] * error * error;
    variance += part;
    squares_over_degrees += part * part / degrees;
  }
  if (!complete) return sum;
  const double degrees = variance > 0.0 ? variance * variance / squares_over_degrees : 1.0;
  set_interval(sum, student_factor(sum.confidence, degrees) * std::sqrt(variance));
  return sum;
}

}  // namespace lac::sim
