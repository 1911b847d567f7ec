// SPDX-License-Identifier: Apache-2.0
// Cross-correlation and delay, and the integral scale (G18 sections 2.2 and 2.3, methods section
// 10).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lac::sim {

enum class PeakSign {
  kPositive,  // the largest correlation
  kEither,    // the largest magnitude: above rated a thrust may fall where the wind rises
};

struct LagRange {
  double min_s = 0.0;
  double max_s = 30.0;
  PeakSign sign = PeakSign::kPositive;
};

/// y follows x: y(t) is like x(t - delay).
struct CorrelationPeak {
  double correlation = 0.0;
  double delay_s = 0.0;
  bool at_edge = false;  // at the first or last lag: the true peak may lie beyond
};

/// Correlation coefficient (Pearson) of x in samples [first, first + length) with y as many samples
/// later as each lag says, mean and deviation of y those of its own stretch, so that a lag costs no
/// samples. The largest of the range, refined with a parabola through its neighbours. Lags whose
/// stretch of y is not wholly inside the series are left out; NaN if none is left, if x does not
/// vary, or a value is not finite.
CorrelationPeak correlation_peak(std::span<const double> x, std::span<const double> y,
                                 double time_step_s, std::size_t first, std::size_t length,
                                 const LagRange& lags);

struct MovingWindow {
  double length_s = 75.0;  // G18: 300 samples at 4 Hz
  double overlap = 0.5;    // of the length
};

struct WindowPlace {
  std::size_t first = 0;
  std::size_t length = 0;
};

/// Windows one behind the other, each whole inside the series. Throws lac::Error unless a window
/// has at least 4 samples and the overlap is from 0 to below 1.
std::vector<WindowPlace> moving_windows(std::size_t samples, double time_step_s,
                                        const MovingWindow& window);

/// Means of `count` samples in a row, one after the other: a plain low-pass with every count-th
/// value kept. What does not fill the last one is left out; a mean over a NaN is NaN.
std::vector<double> block_means(std::span<const double> series, std::size_t count);

/// The autocorrelation coefficient, unbiased (each lag over the pairs it has), integrated to its
/// first zero crossing, trapezoids, linear in the last step [s]. Mean removed, no trend. NaN if it
/// never crosses or the series does not vary. Short windows bias it low.
double integral_time_scale(std::span<const double> series, double time_step_s);

}  // namespace lac::sim
