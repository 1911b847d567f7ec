// SPDX-License-Identifier: Apache-2.0
#include "bridge/tower_signal.hpp"

#include <cmath>

namespace lac {

TowerSignal::Outputs TowerSignal::step(double wanted_rad, double nacelle_direction_rad,
                                       State& s) const noexcept {
  const double c = std::cos(nacelle_direction_rad), n = std::sin(nacelle_direction_rad);
  const double acceleration_mps2 = (wanted_rad - s.angle_rad) / (time_step_s_ * gain_);
  const Outputs out{static_cast<float>(acceleration_mps2 * c),
                    static_cast<float>(acceleration_mps2 * n)};
  s.angle_rad +=
      gain_ * time_step_s_ *
      (static_cast<double>(out.fore_aft_mps2) * c + static_cast<double>(out.side_side_mps2) * n);
  return out;
}

}  // namespace lac
