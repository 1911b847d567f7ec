// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/faddeeva.hpp"

#include <cmath>
#include <numbers>

#include "core/units.hpp"

namespace lac {

Faddeeva::Faddeeva() : width_(std::sqrt(kTerms / std::numbers::sqrt2)) {
  constexpr int kHalf = 2 * kTerms;
  for (int n = 1; n <= kTerms; ++n) {
    double sum = 0.0;
    for (int k = -kHalf + 1; k < kHalf; ++k) {
      const double theta = k * kPi / kHalf;
      const double t = width_ * std::tan(0.5 * theta);
      sum += std::exp(-t * t) * (width_ * width_ + t * t) * std::cos(n * theta);
    }
    coefficients_[static_cast<std::size_t>(n - 1)] = sum / (2 * kHalf);
  }
}

double Faddeeva::real_part(double x, double y) const noexcept {
  // Written out: complex products of the library look for infinities at each step.
  const double below_re = width_ + y, below_im = -x;  // L - iz
  const double scale = 1.0 / (below_re * below_re + below_im * below_im);
  const double inv_re = below_re * scale, inv_im = -below_im * scale;
  const double above_re = width_ - y, above_im = x;  // L + iz
  const double z_re = above_re * inv_re - above_im * inv_im;
  const double z_im = above_re * inv_im + above_im * inv_re;
  double p_re = 0.0, p_im = 0.0;
  for (int n = kTerms - 1; n >= 0; --n) {
    const double re = p_re * z_re - p_im * z_im + coefficients_[static_cast<std::size_t>(n)];
    p_im = p_re * z_im + p_im * z_re;
    p_re = re;
  }
  const double inv2_re = inv_re * inv_re - inv_im * inv_im, inv2_im = 2.0 * inv_re * inv_im;
  return 2.0 * (p_re * inv2_re - p_im * inv2_im) + inv_re * std::numbers::inv_sqrtpi;
}

}  // namespace lac
