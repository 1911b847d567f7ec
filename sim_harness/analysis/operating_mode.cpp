// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/operating_mode.hpp"

#include <array>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace lac::sim {

const char* text_of(OperatingMode mode) {
  switch (mode) {
    case OperatingMode::kNotProducing:
      return "not producing";
    case OperatingMode::kBelowRated:
      return "below rated";
    case OperatingMode::kAboveRated:
      return "above rated";
    default:
      return "mixed";
  }
}

OperatingMode ModeRule::at(double power, double pitch) const {
  if (!(power > least_power_share * rated_power)) return OperatingMode::kNotProducing;
  return pitch > fine_pitch + pitch_margin ? OperatingMode::kAboveRated
                                           : OperatingMode::kBelowRated;
}

OperatingMode ModeRule::of(std::span<const double> power, std::span<const double> pitch) const {
  if (power.size() != pitch.size() || power.empty()) {
    throw Error("operating mode: " + std::to_string(power.size()) + " powers and " +
                std::to_string(pitch.size()) + " pitch angles, expected as many");
  }
  std::array<std::size_t, 3> counts{};
  for (std::size_t i = 0; i < power.size(); ++i)
    ++counts[static_cast<std::size_t>(at(power[i], pitch[i]))];
  for (std::size_t mode = 0; mode < counts.size(); ++mode) {
    if (static_cast<double>(counts[mode]) >= least_share * static_cast<double>(power.size()))
      return static_cast<OperatingMode>(mode);
  }
  return OperatingMode::kMixed;
}

std::vector<Stretch> stretches_in(OperatingMode mode, const ModeRule& rule,
                                  std::span<const double> power, std::span<const double> pitch,
                                  std::span<const double> x, std::span<const double> y,
                                  std::size_t least_samples) {
  std::vector<Stretch> stretches;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= x.size(); ++i) {
    const bool fits = i < x.size() && std::isfinite(x[i]) && std::isfinite(y[i]) &&
                      rule.at(power[i], pitch[i]) == mode;
    if (fits) continue;
    if (i - first >= least_samples && i > first) stretches.push_back({first, i - first});
    first = i + 1;
  }
  return stretches;
}

}  // namespace lac::sim
