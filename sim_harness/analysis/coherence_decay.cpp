// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/coherence_decay.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "sim_harness/analysis/golden_section.hpp"

namespace lac::sim {
namespace {

constexpr double kLargest = 1000.0;
constexpr int kGridSteps = 400;  // of log(1 + alpha), to start in the right valley
constexpr int kSections = 41;    // 1e-10 of 1 + alpha is left of two steps of the grid

}  // namespace

DecayFit fit_decay(std::span<const double> frequency_hz, std::span<const double> coherence,
                   std::span<const double> density, double travel_time_s, double max_hz) {
  const auto misfit = [&](double decay) {
    double sum = 0.0, weight = 0.0;
    for (std::size_t i = 0; i < frequency_hz.size() && frequency_hz[i] <= max_hz; ++i) {
      const double left = coherence[i] - std::exp(-decay * frequency_hz[i] * travel_time_s);
      sum += density[i] * left * left;
      weight += density[i];
    }
    return sum / weight;
  };
  if (!std::isfinite(misfit(1.0))) {
    constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
    return {kNotANumber, kNotANumber};
  }
  const auto on_grid = [](int i) {
    return std::expm1(std::log1p(kLargest) * static_cast<double>(i) / kGridSteps);
  };
  int best = 0;
  for (int i = 1; i <= kGridSteps; ++i)
    if (misfit(on_grid(i)) < misfit(on_grid(best))) best = i;
  const double low = on_grid(best > 0 ? best - 1 : 0);
  const double high = on_grid(best < kGridSteps ? best + 1 : kGridSteps);
  const double decay = golden_section(low, high, kSections, misfit);
  return {decay, std::sqrt(misfit(decay))};
}

}  // namespace lac::sim
