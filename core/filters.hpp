// SPDX-License-Identifier: Apache-2.0
// Discrete filters as values: the coefficients are arguments, the state is a struct that a
// module keeps in its own state. Bilinear transform with prewarping, so that the response is
// exact at the frequency that names the filter.
#pragma once

#include <cmath>

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

/// Delay [s] of a low-pass of first order (cut-off) or second order (natural frequency, damping).
inline double low_pass_delay_s(int order, double lowpass_hz, double damping, double frequency_hz) {
  return order == 1 ? filter_delay_s(lowpass_hz, frequency_hz)
                    : second_order_delay_s(lowpass_hz, damping, frequency_hz);
}

/// First-order low-pass G(s) = w_c/(s + w_c), gain 1/sqrt(2) at the cut-off.
/// y += factor (u + u_previous - 2 y): the state is the output itself, so that a changing cut-off
/// never makes a jump. Starts at the first input.
class LowPass1 {
 public:
  /// Factor for one step; cut-off below the Nyquist frequency. Recompute when it changes.
  static double factor(double cutoff_hz, double time_step_s) {
    const double t = std::tan(kPi * cutoff_hz * time_step_s);
    return t / (1.0 + t);
  }

  void reset(double value) {
    output_ = value;
    input_ = value;
    started_ = true;
  }
  double step(double input, double factor) {
    if (!started_) reset(input);
    output_ += factor * (input + input_ - 2.0 * output_);
    input_ = input;
    return output_;
  }
  double output() const { return output_; }
  bool started() const { return started_; }
  void visit(StateArchive& a) { a(output_), a(input_), a(started_); }

 private:
  double output_ = 0.0;
  double input_ = 0.0;
  bool started_ = false;
};

/// Second-order filter with natural frequency w_0 as two trapezoidal integrators, whose states
/// stay meaningful when the frequency moves. Starts settled at its first input.
class StateVariableFilter {
 public:
  struct Coefficients {
    double g = 0.0;      // tan(w_0 T/2), prewarped
    double width = 0.0;  // 2 z: bandwidth over w_0
    double scale = 1.0;  // 1/(1 + g (width + g))
    void visit(StateArchive& a) { a(g), a(width), a(scale); }
  };
  /// Frequency below the Nyquist frequency.
  static Coefficients coefficients(double natural_hz, double width, double time_step_s) {
    const double g = std::tan(kPi * natural_hz * time_step_s);
    return {g, width, 1.0 / (1.0 + g * (width + g))};
  }

  struct Outputs {
    double band = 0.0;  // w_0 s/(s^2 + width w_0 s + w_0^2)
    double low = 0.0;   // w_0^2/(s^2 + width w_0 s + w_0^2)
  };
  Outputs step(double input, const Coefficients& c) {
    if (!started_) low_state_ = input;
    started_ = true;
    const double high = (input - (c.width + c.g) * band_state_ - low_state_) * c.scale;
    const double band = c.g * high + band_state_;
    const double low = c.g * band + low_state_;
    band_state_ = c.g * high + band;
    low_state_ = c.g * band + low;
    return {band, low};
  }
  void visit(StateArchive& a) { a(band_state_), a(low_state_), a(started_); }

 private:
  double band_state_ = 0.0;
  double low_state_ = 0.0;
  bool started_ = false;
};

/// Notch H(s) = (s^2 + D b s + w_n^2)/(s^2 + b s + w_n^2), b = 2 pi bandwidth: gain D at the
/// centre (0 <= D < 1), 1 far away (methods section 12).
class Notch {
 public:
  struct Coefficients {
    StateVariableFilter::Coefficients filter;
    double depth = 0.0;  // D
    void visit(StateArchive& a) { a(filter), a(depth); }
  };
  static Coefficients coefficients(double centre_hz, double bandwidth_hz, double depth,
                                   double time_step_s) {
    return {StateVariableFilter::coefficients(centre_hz, bandwidth_hz / centre_hz, time_step_s),
            depth};
  }

  double step(double input, const Coefficients& c) {
    return input - (1.0 - c.depth) * c.filter.width * filter_.step(input, c.filter).band;
  }
  void visit(StateArchive& a) { a(filter_); }

 private:
  StateVariableFilter filter_;
};

/// Exact mean until `window_s` has passed, exponential forgetting with that time constant then:
/// a slow mean that needs no memory and has no start-up transient.
class SlowMean {
 public:
  void add(double value, double weight_s, double window_s) {
    elapsed_s_ = elapsed_s_ + weight_s < window_s ? elapsed_s_ + weight_s : window_s;
    mean_ += (value - mean_) * (weight_s < elapsed_s_ ? weight_s / elapsed_s_ : 1.0);
  }
  bool started() const { return elapsed_s_ > 0.0; }
  double elapsed_s() const { return elapsed_s_; }
  double mean() const { return mean_; }
  void visit(StateArchive& a) { a(mean_), a(elapsed_s_); }

 private:
  double mean_ = 0.0;
  double elapsed_s_ = 0.0;
};

}  // namespace lac
