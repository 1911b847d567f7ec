// SPDX-License-Identifier: Apache-2.0
// What the tests of wind files share: bytes put together by hand and a field with a pattern.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "sim_harness/wind/gridded_wind.hpp"

namespace lac::sim {

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
std::string with_value(std::string bytes, std::size_t offset, T value) {
  return bytes.replace(offset, sizeof value,
                       std::string(reinterpret_cast<const char*>(&value), sizeof value));
}

/// 4 x 3 points, 50 steps of 0.25 s at 12.5 m/s, heights 30 to 48 m, hub at 41 m (not the centre);
/// u 12.5 +- 3 m/s, v +- 1.5 m/s, each point with a phase of its own; w = 0.
inline GriddedWind wavy(bool periodic, int nt = 50) {
  VelocityGrid grid({4, 3, nt, 8.0, 9.0, 0.25, 30.0, 41.0, 12.5, periodic});
  for (int it = 0; it < nt; ++it) {
    for (int k = 0; k < 12; ++k) {
      grid.at(it, k / 4, k % 4, 0) = 12.5F + 3.0F * std::sin(0.3F * it + k);
      grid.at(it, k / 4, k % 4, 1) = 1.5F * std::cos(0.7F * it - k);
    }
  }
  return GriddedWind(std::move(grid));
}

}  // namespace lac::sim
