// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_harness/lidar/platform_motion.hpp"

namespace lac::sim {

/// All six degrees of freedom at once, none in step with another.
inline PlatformMotion rough_sea(double pitch_rad) {
  PlatformMotion p;
  p.freedoms[kSurge].harmonics = {{2.0, 12.0, 0.3}};
  p.freedoms[kSway].harmonics = {{1.0, 9.0, 0.0}};
  p.freedoms[kHeave].harmonics = {{0.7, 8.0, 1.0}};
  p.freedoms[kRoll].harmonics = {{0.05, 14.0, 0.0}};
  p.freedoms[kPlatformPitch].harmonics = {{pitch_rad, 25.0, 2.0}};
  p.freedoms[kYaw].harmonics = {{0.1, 40.0, 0.0}};
  return p;
}

}  // namespace lac::sim
