// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/lidar_block.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

struct LidarClockParams {
  double offset_s = 0.0;   // of the time stamp, positive: the stamp is late
  double drift_ppm = 0.0;  // microseconds per second
  int latency_steps = 0;   // controller steps from the measurement to its delivery

  bool enabled() const { return offset_s != 0.0 || drift_ppm != 0.0 || latency_steps > 0; }
};

/// Map `clock`: offset_s (0), drift_ppm (0), latency_steps (0). Throws lac::Error.
LidarClockParams read_lidar_clock(YamlReader& in);

/// What the controller is told of the time of a measurement, and when it gets it:
///
///   stamp = t + offset + drift t
///
/// delivered `latency_steps` controller steps after the lidar had it.
class LidarClock {
 public:
  explicit LidarClock(const LidarClockParams& params);

  /// To be called in every controller step, with what the lidar has; gives the new is_new, and a
  /// measurement whenever that is true.
  bool pass(LidarMeasurement& measurement, bool is_new) noexcept;

 private:
  /// One step's worth of the way to the controller.
  struct Slot {
    LidarMeasurement measurement;
    bool is_new = false;
  };

  LidarClockParams params_;
  std::vector<Slot> line_;  // latency_steps long
  std::size_t at_ = 0;
};

}  // namespace lac::sim
