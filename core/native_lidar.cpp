// SPDX-License-Identifier: Apache-2.0
#include "core/native_lidar.hpp"

#include <cmath>

#include "core/error.hpp"

namespace lac {

void NativeLidar::require(const SwapReader& swap, double /*time_step_s*/,
                          Notice& /*notice*/) const {
  if (swap.holds(kNativeLidarBlock)) return;
  throw Error("LidarLayout native needs records " + std::to_string(kNativeLidarBlock.first) +
              " to " + std::to_string(kNativeLidarBlock.last()) + ", the host's array has " +
              std::to_string(swap.size()) +
              " known records (an extended array has 1001 in record 66 and its length in 129)");
}

bool NativeLidar::fetch(const SwapReader& swap, double /*time_s*/, State& state,
                        LidarMeasurement& m, Notice& notice) const noexcept {
  if (!native_lidar_present(swap)) {
    if (!state.reported) {
      notice.warn(
          "lidar: record %d is not %d: the host fills no native lidar block, or the master "
          "does not pass it on (its key LidarLayout)",
          kNativeLidarBlock.first, native_lidar::kLayoutVersion);
    }
    state.reported = true;
    return false;
  }
  if (!native_lidar_is_new(swap)) return false;
  read_native_lidar(swap, m);
  if (!std::isfinite(m.time_s) || m.time_s == state.last_time_s) return false;
  state.last_time_s = m.time_s;
  return true;
}

}  // namespace lac
