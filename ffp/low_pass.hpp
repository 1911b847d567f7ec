// SPDX-License-Identifier: Apache-2.0
// Low-pass of the feedforward, of first or second order. Bilinear transform, exact at the frequency
// that names the filter.
#pragma once

#include <cmath>

#include "core/filters.hpp"
#include "core/state_archive.hpp"
#include "core/units.hpp"

namespace lac {

/// Order 1: w_c/(s + w_c). Order 2: w_0^2/(s^2 + 2 z w_0 s + w_0^2), w_0 from the same frequency.
/// Starts settled at its first input. Coefficients may change at any step: what is stored are the
/// output (order 1) and the states of the integrators (order 2), so that they make no jump.
class FeedforwardLowPass {
 public:
  struct Coefficients {
    int order = 1;
    double factor = 0.0;                       // order 1
    StateVariableFilter::Coefficients second;  // order 2
    void visit(StateArchive& a) { a(order), a(factor), a(second); }
  };
  /// Frequency below the Nyquist frequency; the damping counts for order 2 alone.
  static Coefficients coefficients(int order, double frequency_hz, double damping,
                                   double time_step_s) {
    if (order == 1) return {1, LowPass1::factor(frequency_hz, time_step_s), {}};
    return {2, 0.0, StateVariableFilter::coefficients(frequency_hz, 2.0 * damping, time_step_s)};
  }

  double step(double input, const Coefficients& c) {
    return c.order == 1 ? first_.step(input, c.factor) : second_.step(input, c.second).low;
  }
  void visit(StateArchive& a) { a(first_), a(second_); }

 private:
  LowPass1 first_;
  StateVariableFilter second_;
};

}  // namespace lac
