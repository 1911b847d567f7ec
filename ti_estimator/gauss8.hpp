// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace lac {

/// Gauss-Legendre rule of eight points on -1 ... 1.
struct GaussPoint {
  double x;  // both signs
  double weight;
};
inline constexpr std::array<GaussPoint, 4> kGauss8{{{0.1834346424956498, 0.3626837833783620},
                                                    {0.5255324099163290, 0.3137066458778873},
                                                    {0.7966664774136267, 0.2223810344533745},
                                                    {0.9602898564975363, 0.1012285362903763}}};

/// Integral of f from a to b.
template <class F>
double gauss8(double a, double b, F f) {
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0.0;
  for (const GaussPoint& p : kGauss8)
    sum += p.weight * (f(middle - half * p.x) + f(middle + half * p.x));
  return half * sum;
}

}  // namespace lac
