// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/extrapolation_inverse.hpp"

namespace lac {

/// Finds out whether the order of extrapolation one was told is the host's: a measurement is held
/// from update to update, so the right inverse moves once per update and any other one rings on
/// for a dozen calls. Values that change at every call tell nothing, and then nothing is said.
class OrderWatch {
 public:
  static constexpr double kSettled_mps = 1.0e-4;  // above what single precision leaves

  enum class Finding { None, OtherOrder, OtherTimes };

  /// One call: a received speed (or a sum of speeds), the order in use, and whether this call lies
  /// on the schedule of measurements (true if there is none). Speaks once.
  Finding step(double received, int order, bool scheduled) noexcept {
    if (done_) return Finding::None;
    std::array<bool, 3> moved{};
    for (std::size_t o = 0; o < inverse_.size(); ++o) {
      const double value = inverse_[o].step(received, static_cast<int>(o));
      const double change = std::abs(value - last_[o]);
      if (change > kUpdate_mps) active_ = ExtrapolationInverse::kSettlingCalls;
      moved[o] = change > kSettled_mps;
      last_[o] = value;
    }
    if (active_ == 0) return Finding::None;
    --active_;
    for (std::size_t o = 0; o < moved.size(); ++o) moves_[o] += moved[o] ? 1 : 0;
    const auto own = static_cast<std::size_t>(order);
    if (moved[own] && !scheduled) ++off_schedule_;
    return moves_[own] < kEnough ? Finding::None : judge(own);
  }

  /// The order whose inverse moves least.
  int best_order() const {
    return static_cast<int>(std::ranges::min_element(moves_) - moves_.begin());
  }

  void visit(StateArchive& a) {
    a(inverse_), a(last_), a(moves_), a(active_), a(off_schedule_), a(done_);
  }

 private:
  static constexpr double kUpdate_mps = 0.02;  // an update worth listening to
  static constexpr int kEnough = 200;
  static constexpr double kClearly = 0.6;    // of the moves of the order in use
  static constexpr double kSometimes = 0.2;  // of them off the schedule

  Finding judge(std::size_t own) noexcept {
    done_ = true;
    const auto best = static_cast<std::size_t>(best_order());
    if (moves_[best] < kClearly * moves_[own]) return Finding::OtherOrder;
    if (off_schedule_ > kSometimes * moves_[own]) return Finding::OtherTimes;
    return Finding::None;
  }

  std::array<ExtrapolationInverse, 3> inverse_;  // of orders 0, 1, 2
  std::array<double, 3> last_{};
  std::array<int, 3> moves_{};
  int active_ = 0;
  int off_schedule_ = 0;
  bool done_ = false;
};

}  // namespace lac
