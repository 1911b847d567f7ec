// SPDX-License-Identifier: Apache-2.0
// Low-pass of the feedforward, of first or second order. Bilinear transform, exact at the frequency
// that names the filter.
#pragma once

#include <cmath>

#include "core/filters.hpp"
#include "core/state_archive.hpp"
#include "core/units.hpp"

namespace lac {

/// Delay [s] of the first-order low-pass at one frequency: atan(w/w_c)/w (HM eq. 26); 1/w_c for
/// frequency 0.
inline double filter_delay_s(double cutoff_hz, double frequency_hz) {
  const double wc = radps_from_hz(cutoff_hz), w = radps_from_hz(frequency_hz);
  return w > 0.0 ? std::atan(w / wc) / w : 1.0 / wc;
}

/// Delay [s] of a second-order system: atan2(2 z w w0, w0^2 - w^2)/w; 2 z/w0 for frequency 0.
inline double second_order_delay_s(double natural_hz, double damping, double frequency_hz) {
  const double w0 = radps_from_hz(natural_hz), w = radps_from_hz(frequency_hz);
  return w > 0.0 ? std::atan2(2.0 * damping * w * w0, w0 * w0 - w * w) / w : 2.0 * damping / w0;
}

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
