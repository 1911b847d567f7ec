// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/state_archive.hpp"

namespace lac {

/// Delays a signal by a time that may change: one value is stored per step, and the value
/// `delay_s` ago is found by linear interpolation. Exact for delays of whole steps.
/// State of a module: built with its size, then never allocates.
class DelayLine {
 public:
  DelayLine() = default;
  /// Longest delay it can hold; longer ones are refused by holds(), never shortened.
  DelayLine(double longest_delay_s, double time_step_s)
      : time_step_s_(time_step_s),
        values_(static_cast<std::size_t>(std::ceil(longest_delay_s / time_step_s)) + 2, 0.0) {}

  void push(double value) noexcept {
    head_ = head_ + 1 == values_.size() ? 0 : head_ + 1;
    values_[head_] = value;
    if (count_ < values_.size()) ++count_;
  }
  void clear() noexcept { count_ = 0; }

  /// Is the value of `delay_s` ago there: short enough for the memory, and enough pushed since
  /// the last clear()?
  bool holds(double delay_s) const noexcept {
    return delay_s >= 0.0 && delay_s / time_step_s_ <= static_cast<double>(count_) - 1.0 + 1e-9;
  }
  /// Precondition: holds(delay_s).
  double at(double delay_s) const noexcept {
    const double steps = delay_s / time_step_s_;
    auto whole = static_cast<std::size_t>(steps + 1e-9);
    const double part = steps - static_cast<double>(whole);
    const double newer = back(whole);
    return part < 1e-9 ? newer : newer + part * (back(whole + 1) - newer);
  }
  void visit(StateArchive& a) { a(values_), a(head_), a(count_); }

 private:
  double back(std::size_t steps) const noexcept {
    return values_[head_ >= steps ? head_ - steps : head_ + values_.size() - steps];
  }

  double time_step_s_ = 1.0;
  std::vector<double> values_{0.0};
  std::size_t head_ = 0;
  std::size_t count_ = 0;
};

}  // namespace lac
