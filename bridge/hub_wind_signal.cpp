// SPDX-License-Identifier: Apache-2.0
#include "bridge/hub_wind_signal.hpp"

#include <algorithm>
#include <cmath>

namespace lac {

double HubWindSignal::step(double level, double yaw_error_rad, State& s) const noexcept {
  constexpr double kSmallestCosine = 0.5;
  s.refused = !(level >= 0.0 && level <= params_.max_level);
  s.level += std::clamp((s.refused ? 1.0 : level) - s.level, -step_, step_);
  return params_.rated_mps * s.level / std::max(std::cos(yaw_error_rad), kSmallestCosine);
}

}  // namespace lac
