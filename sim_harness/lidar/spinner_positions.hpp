// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/lidar/mounting.hpp"

namespace lac::sim {

inline constexpr int kSpinnerPositions = 72;

/// Azimuths of the rotor at which a lidar is looked at before a run [rad], 0 first: all of a
/// spinner's positions, one for a nacelle.
inline std::vector<double> looked_at_azimuths(const Mounting& mounting) {
  const int count = mounting.turns_with_rotor() ? kSpinnerPositions : 1;
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(2.0 * kPi * i / count);
  return all;
}

}  // namespace lac::sim
