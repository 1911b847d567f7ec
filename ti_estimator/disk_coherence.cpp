// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/disk_coherence.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "ti_estimator/gauss8.hpp"

namespace lac {

double disk_coherence(double rate_radius) noexcept {
  // s = pi/2 - t: what counts lies within 1 / (2 c R) of s = 0, so panels grow from there.
  const auto integrand = [&](double s) {
    const double product = std::sin(s) * std::cos(s);
    return product * (0.5 * kPi - s - product) * std::exp(-2.0 * rate_radius * std::sin(s));
  };
  double sum = 0.0, from = 0.0, width = 1.0 / (1.0 + rate_radius);
  while (from < 0.5 * kPi) {
    const double to = std::min(from + width, 0.5 * kPi);
    sum += gauss8(from, to, integrand);
    from = to;
    width *= 1.5;
  }
  return 16.0 / kPi * sum;
}

}  // namespace lac
