// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_clock.hpp"

#include <utility>

namespace lac::sim {
namespace {

constexpr int kLongestLatency = 4000;  // steps

}  // namespace

LidarClockParams read_lidar_clock(YamlReader& in) {
  LidarClockParams p;
  p.offset_s = in.number("offset_s", p.offset_s, Range::between(-60.0, 60.0));
  p.drift_ppm = in.number("drift_ppm", p.drift_ppm, Range::between(-1e5, 1e5));
  p.latency_steps =
      in.integer("latency_steps", p.latency_steps, Range::between(0, kLongestLatency));
  return p;
}

LidarClock::LidarClock(const LidarClockParams& params)
    : params_(params), line_(static_cast<std::size_t>(params.latency_steps)) {}

bool LidarClock::pass(LidarMeasurement& m, bool is_new) noexcept {
  if (is_new) m.time_s += params_.offset_s + 1e-6 * params_.drift_ppm * m.time_s;
  if (line_.empty()) return is_new;
  Slot& slot = line_[at_];
  at_ = (at_ + 1) % line_.size();
  const bool had = slot.is_new;
  slot.is_new = is_new;
  if (had) {
    std::swap(slot.measurement, m);
  } else if (is_new) {
    slot.measurement = m;
  }
  return had;
}

}  // namespace lac::sim
