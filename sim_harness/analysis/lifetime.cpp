// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/lifetime.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kHoursPerYear = 8760.0;
constexpr double kLoneBin_mps = 2.0;

void require_equal_length(std::size_t values, std::size_t probabilities) {
  if (values == probabilities) return;
  throw Error("lifetime: " + std::to_string(values) + " values for " +
              std::to_string(probabilities) + " bins");
}

}  // namespace

WindDistribution WindDistribution::rayleigh(double mean_speed_mps) {
  if (!(mean_speed_mps > 0.0) || !std::isfinite(mean_speed_mps)) {
    throw Error("wind distribution: mean speed " + std::to_string(mean_speed_mps) +
                " m/s, expected above 0");
  }
  return {mean_speed_mps / std::tgamma(1.5), 2.0};
}

double WindDistribution::probability_below(double speed_mps) const {
  return speed_mps > 0.0 ? -std::expm1(-std::pow(speed_mps / scale_mps, shape)) : 0.0;
}

std::vector<double> bin_probabilities(const WindDistribution& wind,
                                      std::span<const double> speeds_mps) {
  const std::size_t n = speeds_mps.size();
  for (std::size_t i = 1; i < n; ++i) {
    if (!(speeds_mps[i] > speeds_mps[i - 1]))
      throw Error("lifetime: wind speeds must rise, found " + std::to_string(speeds_mps[i]) +
                  " m/s after " + std::to_string(speeds_mps[i - 1]) + " m/s");
  }
  if (n == 0) return {};
  std::vector<double> edges_mps(n + 1);
  for (std::size_t i = 1; i < n; ++i) edges_mps[i] = 0.5 * (speeds_mps[i - 1] + speeds_mps[i]);
  const double first_half = n > 1 ? edges_mps[1] - speeds_mps[0] : 0.5 * kLoneBin_mps;
  const double last_half = n > 1 ? speeds_mps[n - 1] - edges_mps[n - 1] : 0.5 * kLoneBin_mps;
  edges_mps[0] = std::max(speeds_mps[0] - first_half, 0.0);
  edges_mps[n] = speeds_mps[n - 1] + last_half;
  std::vector<double> shares(n);
  for (std::size_t i = 0; i < n; ++i) {
    shares[i] = wind.probability_below(edges_mps[i + 1]) - wind.probability_below(edges_mps[i]);
  }
  return shares;
}

double mean_load(std::span<const double> loads, double woehler_exponent) {
  const std::vector<double> equal(loads.size(), 1.0 / static_cast<double>(loads.size()));
  return lifetime_load(loads, equal, woehler_exponent);
}

double lifetime_load(std::span<const double> loads, std::span<const double> probabilities,
                     double woehler_exponent) {
  require_equal_length(loads.size(), probabilities.size());
  double damage = 0.0;
  for (std::size_t i = 0; i < loads.size(); ++i)
    damage += probabilities[i] * std::pow(loads[i], woehler_exponent);
  return std::pow(damage, 1.0 / woehler_exponent);
}

double annual_energy(std::span<const double> mean_powers, std::span<const double> probabilities) {
  require_equal_length(mean_powers.size(), probabilities.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < mean_powers.size(); ++i) sum += probabilities[i] * mean_powers[i];
  return kHoursPerYear * sum;
}

}  // namespace lac::sim
