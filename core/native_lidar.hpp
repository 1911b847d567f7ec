// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lidar_block.hpp"
#include "core/notice.hpp"
#include "core/state_archive.hpp"

namespace lac {

/// Measurements out of our own block (records 1101 on), which carries everything itself.
class NativeLidar {
 public:
  struct State {
    double last_time_s = -1.0e30;
    bool reported = false;
    void visit(StateArchive& a) { a(last_time_s), a(reported); }
  };

  /// Throws lac::Error if the array cannot carry the block.
  void require(const SwapReader& swap, double time_step_s, Notice& notice) const;
  State initial_state() const { return {}; }
  /// True if the flag is up and the time of the measurement has changed. A missing block is
  /// reported once.
  bool fetch(const SwapReader& swap, double time_s, State& state, LidarMeasurement& m,
             Notice& notice) const noexcept;
};

}  // namespace lac
