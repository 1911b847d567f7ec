// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sim_harness/lidar/scan_pattern.hpp"

namespace lac::sim {

/// A stretch of a scan, and the beams that are taken during it: one, or all at once.
struct ScanSlot {
  std::size_t first_beam = 0;
  std::size_t beam_count = 1;
  double length_s = 0.0;
  double before_scan_end_s = 0.0;  // from its end to that of the scan, pauses included
};

/// Goes through the slots of scan after scan.
class ScanClock {
 public:
  explicit ScanClock(const ScanPattern& pattern);

  const ScanSlot& slot() const { return slots_[slot_]; }
  /// Of the present slot; the first scan begins at time 0. Rounded once, not summed up.
  double end_s() const {
    return static_cast<double>(scan_ + 1) * scan_time_s_ - slot().before_scan_end_s;
  }
  double begin_s() const { return end_s() - slot().length_s; }
  /// When the i-th of the samples is taken.
  double sample_time_s(int i) const;
  void next();

  std::size_t slots_per_scan() const { return slots_.size(); }
  double scan_time_s() const { return scan_time_s_; }

 private:
  std::vector<ScanSlot> slots_;
  double scan_time_s_;
  int samples_;
  std::int64_t scan_ = 0;
  std::size_t slot_ = 0;
};

}  // namespace lac::sim
