// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ti_estimator/sample_window.hpp"

namespace lac {

/// Mean and variance of samples weighted with exp(-age / time constant).
class ExponentialMoments {
 public:
  void add(double value, double time_s, double time_constant_s) noexcept {
    const double kept = weight_ > 0.0 ? std::exp(-(time_s - last_s_) / time_constant_s) : 0.0;
    last_s_ = time_s;
    weight_ = kept * weight_ + 1.0;
    squared_weights_ = kept * kept * squared_weights_ + 1.0;
    const double before = value - mean_;
    mean_ += before / weight_;
    squares_ = kept * squares_ + before * (value - mean_);
  }
  /// Sum of the weights at a time.
  double weight(double time_s, double time_constant_s) const noexcept {
    return weight_ * std::exp(-(time_s - last_s_) / time_constant_s);
  }
  double mean() const { return mean_; }
  /// Without bias for independent samples. Precondition: two samples at different times or more.
  double variance() const { return squares_ / (weight_ - squared_weights_ / weight_); }

  void visit(StateArchive& a) {
    a(weight_), a(squared_weights_), a(mean_), a(squares_), a(last_s_);
  }

 private:
  double weight_ = 0.0;  // at the last sample, as the others
  double squared_weights_ = 0.0;
  double mean_ = 0.0;
  double squares_ = 0.0;
  double last_s_ = 0.0;
};

/// As SampleWindow, with weights exp(-2 age / T) instead of an end: old samples fade out. It needs
/// no memory of single samples.
class ExponentialWindow {
 public:
  ExponentialWindow() = default;
  ExponentialWindow(int beams, int gates, double window_s, double scan_time_s)
      : beams_(beams),
        gates_(static_cast<std::size_t>(gates)),
        window_s_(window_s),
        look_every_s_(scan_time_s / beams),
        full_weight_(1.0 / -std::expm1(-2.0 * scan_time_s / window_s)),
        series_(static_cast<std::size_t>(beams) * gates_) {}

  void add(double time_s, int beam, std::span<const std::int32_t> row) noexcept {
    if (!started_) start_s_ = time_s;
    started_ = true;
    ExponentialMoments* series = &series_[static_cast<std::size_t>(beam) * gates_];
    for (std::size_t g = 0; g < gates_; ++g) {
      if (row[g] == SampleWindow::kNone) continue;
      series[g].add(row[g] / RunningMoments::kUnitsPerMps, time_s, 0.5 * window_s_);
    }
  }

  /// The next beam to look at anew, as its weights fade: each once a scan; else -1.
  int expire(double time_s) noexcept {
    if (!started_ || time_s - looked_s_ < look_every_s_) return -1;
    looked_s_ = time_s;
    looked_at_ = looked_at_ + 1 < beams_ ? looked_at_ + 1 : 0;
    return looked_at_;
  }

  bool has_lasted(double time_s) const {
    return started_ && time_s - start_s_ >= window_s_ - SampleWindow::kTolerance_s;
  }
  const ExponentialMoments& series(int beam, int gate) const {
    return series_[static_cast<std::size_t>(beam) * gates_ + static_cast<std::size_t>(gate)];
  }
  /// Sum of the weights of a series, a sample just come having 1.
  double weight(int beam, int gate, double time_s) const {
    return series(beam, gate).weight(time_s, 0.5 * window_s_);
  }
  /// That of a series without gaps.
  double full_weight() const { return full_weight_; }

  void visit(StateArchive& a) { a(series_), a(start_s_), a(started_), a(looked_s_), a(looked_at_); }

 private:
  int beams_ = 0;
  std::size_t gates_ = 0;
  double window_s_ = 0.0;
  double look_every_s_ = 0.0;
  double full_weight_ = 1.0;
  std::vector<ExponentialMoments> series_;  // beams x gates
  double start_s_ = 0.0;
  bool started_ = false;
  double looked_s_ = 0.0;
  int looked_at_ = 0;
};

}  // namespace lac
