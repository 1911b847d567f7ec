// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/scan_clock.hpp"

namespace lac::sim {
namespace {

std::vector<ScanSlot> slots_of(const ScanPattern& pattern) {
  if (pattern.simultaneous) {
    return {{0, pattern.beams.size(), pattern.beam_time_s, pattern.scan_pause_s}};
  }
  std::vector<ScanSlot> slots(pattern.beams.size());
  double before_scan_end_s = pattern.scan_pause_s;
  for (std::size_t i = slots.size(); i-- > 0;) {
    slots[i] = {i, 1, pattern.time_of_s(pattern.beams[i]), before_scan_end_s};
    before_scan_end_s += slots[i].length_s + pattern.beam_pause_s;
  }
  return slots;
}

}  // namespace

ScanClock::ScanClock(const ScanPattern& pattern)
    : slots_(slots_of(pattern)),
      scan_time_s_(pattern.scan_time_s()),
      samples_(pattern.samples_per_beam) {}

double ScanClock::sample_time_s(int i) const {
  if (samples_ == 1) return end_s();
  return begin_s() + (i + 0.5) / samples_ * slot().length_s;
}

void ScanClock::next() {
  if (++slot_ < slots_.size()) return;
  slot_ = 0;
  ++scan_;
}

}  // namespace lac::sim
