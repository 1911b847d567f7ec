// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ti_estimator/correction.hpp"
#include "ti_estimator/exponential_window.hpp"
#include "ti_estimator/sample_window.hpp"

namespace lac {

/// What statistics over T are wanted of the wind speeds per beam and gate.
struct StatisticsSpec {
  Window window = Window::Sliding;
  Detrending detrending = Detrending::Mean;
  double window_s = 180.0;  // T
  double scan_time_s = 1.0;
  double minimum_fill = 0.5;  // of the samples, or their weight, that a series needs to count
  int beams = 4;
  int gates = 10;

  double expected_samples() const { return window_s / scan_time_s; }
  int needed_samples() const;
};

/// Mean and sample standard deviation per beam and gate over the last T seconds, by the window and
/// detrending asked for. Memory is taken when it is built.
class SpeedStatistics {
 public:
  struct Series {
    bool filled = false;  // else the rest means nothing
    double mean_mps = 0.0;
    double standard_deviation_mps = 0.0;
  };

  SpeedStatistics() = default;
  explicit SpeedStatistics(const StatisticsSpec& spec);

  /// As SampleWindow::add().
  bool add(double time_s, int beam, std::span<const std::int32_t> row) noexcept {
    if (!exponential()) return sliding_.add(time_s, beam, row);
    fading_.add(time_s, beam, row);
    return true;
  }
  /// The beam whose statistics have changed because samples grew old, or -1. To be called at least
  /// as often as measurements come.
  int expire(double time_s) noexcept {
    return exponential() ? fading_.expire(time_s) : sliding_.expire(time_s);
  }
  /// True once T has passed since the first sample.
  bool has_lasted(double time_s) const {
    return exponential() ? fading_.has_lasted(time_s) : sliding_.has_lasted(time_s);
  }
  Series series(int beam, int gate, double time_s) const noexcept;

  void visit(StateArchive& a) { a(sliding_), a(fading_); }

 private:
  bool exponential() const { return spec_.window == Window::Exponential; }

  StatisticsSpec spec_;
  int needed_samples_ = 0;
  SampleWindow sliding_;  // one of the two is empty
  ExponentialWindow fading_;
};

}  // namespace lac
