// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace lac {

/// Real part of w(x + iy) = exp(-z^2) erfc(-iz), y >= 0. Rational series of 32 terms (Weideman
/// 1994, SIAM J. Numer. Anal. 31(5), 1497-1518); error below 1e-11. w(x).re = exp(-x^2),
/// w(iy) = exp(y^2) erfc(y).
class Faddeeva {
 public:
  Faddeeva();
  double real_part(double x, double y) const noexcept;

 private:
  static constexpr int kTerms = 32;
  double width_;
  std::array<double, kTerms> coefficients_;
};

}  // namespace lac
