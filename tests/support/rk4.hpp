// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace lac::test {

/// Classic fixed-step Runge-Kutta method over one interval, in `steps` steps: the reference for
/// solvers with error control. `function(time_s, state, rates)`, time from the interval's start.
template <std::size_t n, typename Function>
void rk4(const Function& function, double duration_s, int steps, std::array<double, n>& state) {
  const double h = duration_s / steps;
  std::array<double, n> k1{}, k2{}, k3{}, k4{}, y{};
  const auto shifted = [&](const std::array<double, n>& k, double factor) -> const double* {
    for (std::size_t i = 0; i < n; ++i) y[i] = state[i] + factor * k[i];
    return y.data();
  };
  for (int step = 0; step < steps; ++step) {
    const double t = h * step;
    function(t, state.data(), k1.data());
    function(t + 0.5 * h, shifted(k1, 0.5 * h), k2.data());
    function(t + 0.5 * h, shifted(k2, 0.5 * h), k3.data());
    function(t + h, shifted(k3, h), k4.data());
    for (std::size_t i = 0; i < n; ++i) {
      state[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
  }
}

}  // namespace lac::test
