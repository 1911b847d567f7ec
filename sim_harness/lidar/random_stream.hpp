// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "sim_harness/wind/complex_normal.hpp"

namespace lac::sim {

/// What a lidar draws random numbers for. Each has a sequence of its own, so that switching one
/// weakness on leaves the others as they were.
enum class LidarStream : std::uint64_t { kScatter, kDrift, kOutage, kBurst, kNoise, kFault };

/// Random numbers of one lidar weakness; the same seed gives the same numbers everywhere.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, LidarStream stream)
      : draw_(seed, kLidar, static_cast<std::uint64_t>(stream)) {}

  double normal() noexcept { return std::numbers::sqrt2 * draw_().real(); }
  /// |xi|^2 is exponential, so exp(-|xi|^2) is uniform.
  bool happens(double probability) noexcept { return std::exp(-std::norm(draw_())) < probability; }

 private:
  static constexpr std::uint64_t kLidar = 0x6c69646172;  // away from the streams of the wind

  ComplexNormal draw_;
};

}  // namespace lac::sim
