// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/state_archive.hpp"
#include "ti_estimator/trend_moments.hpp"

namespace lac {

/// The wind speeds of the last T seconds, per beam and gate, and their running moments.
///
/// A row is one measurement: a beam and a value or kNone for each of its gates. Rows leave by
/// time, not pushed out by new ones: through a dropout the window empties at the pace at which
/// it was filled. Memory is taken when the window is built; add() and expire() are O(gates).
class SampleWindow {
 public:
  static constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::min();
  static constexpr double kTolerance_s = 1.0e-6;  // times are multiples of the step, rounded

  SampleWindow() = default;
  /// Room for `rows` measurements of `beams` beams with `gates` gates each.
  SampleWindow(int beams, int gates, int rows, double window_s)
      : gates_(static_cast<std::size_t>(gates)),
        window_s_(window_s),
        series_(static_cast<std::size_t>(beams) * gates_),
        arrival_s_(static_cast<std::size_t>(rows)),
        beam_(static_cast<std::size_t>(rows)),
        values_(static_cast<std::size_t>(rows) * gates_) {}

  /// Takes one row with a value for each gate; false if there is no room left. Times must not go
  /// back.
  bool add(double time_s, int beam, std::span<const std::int32_t> row) noexcept {
    if (count_ == arrival_s_.size()) return false;
    if (count_ == 0) begin_anew(time_s);
    move_origin_near(time_s);
    const std::int64_t tick = tick_of(time_s);
    std::size_t at = first_ + count_;
    if (at >= arrival_s_.size()) at -= arrival_s_.size();
    arrival_s_[at] = time_s;
    beam_[at] = beam;
    for (std::size_t g = 0; g < gates_; ++g) {
      values_[at * gates_ + g] = row[g];
      if (row[g] != kNone) series_of(beam)[g].add(row[g], tick);
    }
    ++count_;
    return true;
  }

  /// Lets the oldest row go if it is T old; gives its beam, else -1. One row per call: the caller
  /// comes at least as often as measurements do.
  int expire(double time_s) noexcept {
    if (count_ == 0 || time_s - arrival_s_[first_] < window_s_ - kTolerance_s) return -1;
    const int beam = beam_[first_];
    const std::int64_t tick = tick_of(arrival_s_[first_]);
    for (std::size_t g = 0; g < gates_; ++g) {
      const std::int32_t value = values_[first_ * gates_ + g];
      if (value != kNone) series_of(beam)[g].remove(value, tick);
    }
    if (++first_ == arrival_s_.size()) first_ = 0;
    --count_;
    return beam;
  }

  /// True once T has passed since the first row; a window that ran empty begins anew.
  bool has_lasted(double time_s) const {
    return count_ > 0 && time_s - start_s_ >= window_s_ - kTolerance_s;
  }
  const TrendMoments& series(int beam, int gate) const {
    return series_[static_cast<std::size_t>(beam) * gates_ + static_cast<std::size_t>(gate)];
  }

  void visit(StateArchive& a) {
    a(series_), a(arrival_s_), a(beam_), a(values_), a(first_), a(count_), a(start_s_);
    a(origin_);
  }

 private:
  static constexpr std::int64_t kFarthestTick = std::int64_t{1} << 18;  // above the longest T

  void begin_anew(double time_s) noexcept {
    start_s_ = time_s;
    origin_ = 0;
    origin_ = tick_of(time_s);
  }
  /// From the origin, the same for a row when it comes and when it leaves but for what the origin
  /// has moved in between.
  std::int64_t tick_of(double time_s) const noexcept {
    return std::llround(time_s * TrendMoments::kTicksPerSecond) - origin_;
  }
  /// Keeps ticks small: rows are at most T old.
  void move_origin_near(double time_s) noexcept {
    if (tick_of(time_s) < kFarthestTick) return;
    const std::int64_t ticks = tick_of(time_s);
    origin_ += ticks;
    for (TrendMoments& series : series_) series.move_origin(ticks);
  }

  TrendMoments* series_of(int beam) { return &series_[static_cast<std::size_t>(beam) * gates_]; }

  std::size_t gates_ = 0;
  double window_s_ = 0.0;
  std::vector<TrendMoments> series_;  // beams x gates
  std::vector<double> arrival_s_;     // ring of rows
  std::vector<std::int32_t> beam_;    // ring of rows
  std::vector<std::int32_t> values_;  // ring of rows x gates, units of RunningMoments
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  double start_s_ = 0.0;
  std::int64_t origin_ = 0;  // of the ticks
};

}  // namespace lac
