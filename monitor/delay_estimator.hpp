// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "monitor/lagged_moments.hpp"

namespace lac {

/// How much later y is than x, from their running covariances.
struct DelayEstimate {
  double delay_s = std::numeric_limits<double>::quiet_NaN();  // none: peak at the end of the range
  double correlation = 0.0;  // coefficient at that delay; the largest one if there is none
};

/// Lag of the largest correlation coefficient, a parabola through it and its neighbours (methods
/// section 10). Lags up to `range` ticks either way. [real time]
DelayEstimate correlation_delay(const LaggedMoments& moments, std::size_t range,
                                double tick_s) noexcept;

/// Delay after Moddemeijer (1988), methods section 10: with a wrong lag the past of one signal
/// foretells the future of the other. Minimises over the lag l
///
///     I = 1/2 (ln det C_pp + ln det C_ff - ln det C)
///
/// past and future: m samples of x(t) and m of y(t + l) each, `spacing` ticks apart, jointly
/// Gaussian. One lag per step() is evaluated, so that the cost is even; a delay comes out after
/// each sweep, refined with a parabola.
class Moddemeijer {
 public:
  static constexpr std::size_t kSamples = 3;  // m

  struct State {
    std::vector<double> information;  // of each lag
    std::size_t next = 0;
    double delay_s = std::numeric_limits<double>::quiet_NaN();
    void visit(StateArchive& a) { a(information), a(next), a(delay_s); }
  };

  /// Covariances it needs beyond the range of lags.
  static std::size_t margin(std::size_t spacing) { return (2 * kSamples - 1) * spacing; }

  Moddemeijer(std::size_t range, std::size_t spacing, double tick_s)
      : range_(range), spacing_(spacing), tick_s_(tick_s) {}
  State initial_state() const;

  /// Precondition: moments with max_lag >= range + margin, max_auto >= margin. [real time]
  void step(const LaggedMoments& moments, State& state) const noexcept;

  /// I(past; future) at this lag [nat]; not a number if the covariances are none.
  double information(const LaggedMoments& moments, std::ptrdiff_t lag) const noexcept;

 private:
  std::size_t range_;
  std::size_t spacing_;
  double tick_s_;
};

}  // namespace lac
