// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/state_archive.hpp"

namespace lac {

/// Wind samples sorted by the step at which they reach the rotor, and the sum over a window of
/// arrival steps that moves along. Adding a sample and moving the window by a step are O(1).
///
/// Sums are whole numbers of 2^-20 m/s, so that taking samples out again is exact: the mean
/// never drifts, however long the run. |speed| below 1000 m/s.
class ArrivalBins {
 public:
  ArrivalBins() = default;
  /// Room for `horizon` steps ahead of the step given to advance().
  explicit ArrivalBins(std::size_t horizon)
      : bins_(std::bit_ceil(horizon)), horizon_(static_cast<std::int64_t>(horizon)) {}

  /// Forgets what arrived before `now` (never goes back).
  void advance(std::int64_t now) noexcept {
    for (; now_ < now; ++now_) {
      Bin& bin = at(now_);
      if (in_window(now_)) take(bin, -1);
      bin = {};
    }
    if (first_ < now_) first_ = now_;
    if (last_ < first_ - 1) last_ = first_ - 1;
  }

  /// False if the arrival lies before now or beyond the horizon: not stored.
  bool add(std::int64_t arrival, double speed_mps) noexcept {
    if (arrival < now_ || arrival >= now_ + horizon_) return false;
    Bin sample{std::llround(speed_mps * kScale), 1};
    Bin& bin = at(arrival);
    bin.sum += sample.sum;
    bin.count += 1;
    if (in_window(arrival)) take(sample, +1);
    return true;
  }

  /// Moves the window to the arrival steps first..last, both included, inside the horizon.
  void set_window(std::int64_t first, std::int64_t last) noexcept {
    if (first < now_) first = now_;
    if (last < first - 1) last = first - 1;
    if (first > last_ || last < first_) {  // no overlap with the old one: begin anew
      window_ = {};
      first_ = first;
      last_ = first - 1;
    }
    while (last_ < last) take(at(++last_), +1);
    while (last_ > last) take(at(last_--), -1);
    while (first_ > first) take(at(--first_), +1);
    while (first_ < first) take(at(first_++), -1);
  }

  int count() const { return window_.count; }
  /// Precondition: count() > 0.
  double mean_mps() const {
    return static_cast<double>(window_.sum) / kScale / static_cast<double>(window_.count);
  }

  void visit(StateArchive& a) { a(bins_), a(window_), a(now_), a(first_), a(last_); }

 private:
  static constexpr double kScale = 1048576.0;
  struct Bin {
    std::int64_t sum = 0;
    std::int32_t count = 0;
    void visit(StateArchive& a) { a(sum), a(count); }
  };

  Bin& at(std::int64_t step) noexcept {
    return bins_[static_cast<std::size_t>(step) & (bins_.size() - 1)];
  }
  bool in_window(std::int64_t step) const { return step >= first_ && step <= last_; }
  void take(const Bin& bin, int sign) noexcept {
    window_.sum += sign * bin.sum;
    window_.count += sign * bin.count;
  }

  std::vector<Bin> bins_ = std::vector<Bin>(1);  // a power of two, so that places need no division
  std::int64_t horizon_ = 1;
  Bin window_;
  std::int64_t now_ = 0;
  std::int64_t first_ = 0;
  std::int64_t last_ = -1;
};

}  // namespace lac
