// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lac::sim {

/// Where f is least between low and high, if it has one minimum there: golden section, one value of
/// f a step. What is left of the interval is 0.618^sections of it: 4e-9 after 40.
template <class Function>
double golden_section(double low, double high, int sections, Function&& f) {
  constexpr double kGolden = 0.6180339887498949;
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double at_left = f(left), at_right = f(right);
  for (int i = 0; i < sections; ++i) {
    if (at_left < at_right) {
      high = right, right = left, at_right = at_left;
      at_left = f(left = high - kGolden * (high - low));
    } else {
      low = left, left = right, at_left = at_right;
      at_right = f(right = low + kGolden * (high - low));
    }
  }
  return 0.5 * (low + high);
}

}  // namespace lac::sim
