// SPDX-License-Identifier: Apache-2.0
#include "bridge/added_demands.hpp"

#include <algorithm>

namespace lac {

float AddedDemands::limit(double wanted_rad, double before_rad, bool& limited) const noexcept {
  const double inside_rad = std::clamp(wanted_rad, params_.min_rad, params_.max_rad);
  const double given_rad = std::clamp(inside_rad, before_rad - step_rad_, before_rad + step_rad_);
  limited = limited || given_rad != wanted_rad;
  return static_cast<float>(given_rad);
}

bool AddedDemands::is_at_a_limit(float demand_rad) const noexcept {
  return demand_rad == static_cast<float>(params_.min_rad) ||
         demand_rad == static_cast<float>(params_.max_rad);
}

bool AddedDemands::step(double increment_rad, Demands& demands, State& s) const noexcept {
  bool limited = false;
  for (std::size_t i = 0; i < kDemands; ++i) {
    if (!s.started) s.base[i] = s.given[i] = demands[i];
    const bool settled = s.given[i] == s.base[i];
    const bool written = settled || is_at_a_limit(s.given[i]) || demands[i] != s.given[i];
    if (i == 0) s.not_written = written ? 0 : s.not_written + 1;
    if (written) s.base[i] = demands[i];
    if (increment_rad != 0.0 || !settled) {
      const double wanted_rad = static_cast<double>(s.base[i]) + increment_rad;
      demands[i] = limit(wanted_rad, static_cast<double>(s.given[i]), limited);
    }
    s.given[i] = demands[i];
  }
  s.started = true;
  return limited;
}

}  // namespace lac
