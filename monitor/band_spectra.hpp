// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "core/state_archive.hpp"
#include "core/units.hpp"

namespace lac {

/// Running spectra of two signals in a few bands: complex demodulation at f_j, low-pass of two
/// equal poles, products with exponential forgetting,
///
///     X_j = low-pass of x e^(-i 2 pi f_j t),   S_xy,j = E[conj(X_j) Y_j],   likewise S_xx, S_yy.
///
/// The low-pass has its -3 dB point `half_width_hz` beside f_j; two poles keep out what a spectrum
/// that falls has far below f_j. A y that is late by T turns the phase of S_xy,j by -2 pi f_j T.
/// State of a module: built with its size, then never allocates.
class BandSpectra {
 public:
  BandSpectra() = default;
  BandSpectra(const std::vector<double>& frequency_hz, double half_width_hz, double tick_s)
      : smoothing_(1.0 - std::exp(-radps_from_hz(half_width_hz / kHalfWidthPerPole) * tick_s)),
        noise_bandwidth_hz_(0.5 * kPi * half_width_hz / kHalfWidthPerPole) {
    for (const double f : frequency_hz) {
      const double angle = -radps_from_hz(f) * tick_s;
      Band b;
      b.frequency_hz = f;
      b.turn_re = std::cos(angle);
      b.turn_im = std::sin(angle);
      bands_.push_back(b);
    }
  }

  /// One signal, demodulated.
  struct Tone {
    double first_re = 0.0, first_im = 0.0, re = 0.0, im = 0.0;
    void add(double re_in, double im_in, double smoothing) noexcept {
      first_re += smoothing * (re_in - first_re);
      first_im += smoothing * (im_in - first_im);
      re += smoothing * (first_re - re);
      im += smoothing * (first_im - im);
    }
    void visit(StateArchive& a) { a(first_re), a(first_im), a(re), a(im); }
  };
  struct Band {
    double frequency_hz = 0.0;
    double turn_re = 1.0, turn_im = 0.0;  // of the carrier in one tick
    double carrier_re = 1.0, carrier_im = 0.0;
    Tone x, y;
    double xx = 0.0, yy = 0.0, xy_re = 0.0, xy_im = 0.0;

    /// Magnitude squared, 0 while there is none.
    double coherence() const noexcept {
      const double power = xx * yy;
      return power > 0.0 ? (xy_re * xy_re + xy_im * xy_im) / power : 0.0;
    }
    void visit(StateArchive& a) {
      a(carrier_re), a(carrier_im), a(x), a(y), a(xx), a(yy), a(xy_re), a(xy_im);
    }
  };

  /// `share`: what the newest product counts, 1 for the first.
  void add(double x, double y, double share) noexcept {
    for (Band& b : bands_) {
      turn(b);
      b.x.add(x * b.carrier_re, x * b.carrier_im, smoothing_);
      b.y.add(y * b.carrier_re, y * b.carrier_im, smoothing_);
      b.xx += share * (b.x.re * b.x.re + b.x.im * b.x.im - b.xx);
      b.yy += share * (b.y.re * b.y.re + b.y.im * b.y.im - b.yy);
      b.xy_re += share * (b.x.re * b.y.re + b.x.im * b.y.im - b.xy_re);
      b.xy_im += share * (b.x.re * b.y.im - b.x.im * b.y.re - b.xy_im);
    }
  }

  const std::vector<Band>& bands() const noexcept { return bands_; }

  /// Mean coherence of the bands up to `highest_hz`, the first one always.
  double mean_coherence(double highest_hz) const noexcept {
    double sum = 0.0;
    int count = 0;
    for (const Band& b : bands_) {
      if (count > 0 && b.frequency_hz > highest_hz) break;
      sum += b.coherence();
      ++count;
    }
    return count > 0 ? sum / count : 0.0;
  }

  /// Share of x that leaves the least of y, over all bands: sum of Re S_xy over sum of S_xx.
  struct Slope {
    double value = 0.0;
    double deviation = 0.0;  // standard, after as long as this
  };
  /// The deviation is that of a gain from n products, |slope| sqrt((1 - c)/(2 c n)) (Bendat and
  /// Piersol), c the mean coherence; each band gives its noise bandwidth times the time.
  Slope slope(double time_s) const noexcept {
    Slope s;
    double xy = 0.0, xx = 0.0;
    for (const Band& b : bands_) {
      xy += b.xy_re;
      xx += b.xx;
    }
    if (!(xx > 0.0)) return s;
    s.value = xy / xx;
    const double c = mean_coherence(bands_.back().frequency_hz);
    const double products = static_cast<double>(bands_.size()) * noise_bandwidth_hz_ * time_s;
    if (c > 0.0) s.deviation = std::abs(s.value) * std::sqrt((1.0 - c) / (2.0 * c * products));
    return s;
  }

  void visit(StateArchive& a) { a(bands_); }

 private:
  static constexpr double kHalfWidthPerPole = 0.6436;  // sqrt(sqrt 2 - 1)

  /// The carrier stays on the unit circle: one step of Newton for 1/|c| each time.
  static void turn(Band& b) noexcept {
    const double re = b.carrier_re * b.turn_re - b.carrier_im * b.turn_im;
    const double im = b.carrier_re * b.turn_im + b.carrier_im * b.turn_re;
    const double scale = 1.5 - 0.5 * (re * re + im * im);
    b.carrier_re = scale * re;
    b.carrier_im = scale * im;
  }

  double smoothing_ = 1.0;
  double noise_bandwidth_hz_ = 0.0;
  std::vector<Band> bands_;
};

}  // namespace lac
