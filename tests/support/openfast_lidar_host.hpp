// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "core/swap_view.hpp"

namespace lac::test {

/// OpenFAST's lidar block as a controller gets it: measurements held from update to update, all
/// values extrapolated by one step with a polynomial, in single precision.
struct OpenFastLidarHost {
  int sensor_type = 3;
  int order = 2;  // InterpOrder
  double time_step_s = 0.00625;
  int steps_per_measurement = 40;
  std::vector<double> x_m{-205.0, -175.0, -145.0, -115.0, -85.0};
  /// Speed measured at time t at a point x.
  std::function<double(double, double)> wind_mps = [](double, double) { return 16.0; };
  /// Movement of the hub, which carries the points along.
  std::function<double(double)> hub_m = [](double) { return 0.0; };
  /// Steps at which OpenFAST skips a measurement that is due.
  std::function<bool(long)> skips = [](long) { return false; };

  std::size_t points() const { return x_m.size(); }

  /// The measurement that is held at a step: speed and x of a point.
  std::pair<double, double> held(long step, std::size_t point) const {
    long taken = (step < 0 ? 0 : step) / steps_per_measurement * steps_per_measurement;
    while (taken > 0 && skips(taken)) taken -= steps_per_measurement;
    const double t = static_cast<double>(taken) * time_step_s;
    const double x = x_m[point] + hub_m(t);
    return {wind_mps(t, x), x};
  }

  /// Fills the block as it is at the call of a step; the first two calls carry the same.
  void fill(SwapView swap, long step) const {
    const int first = kOpenFastLidarBlock.first;
    const auto n = static_cast<int>(points());
    swap.put(first, sensor_type);
    swap.put(first + 1, sensor_type == 3 ? 1 : n);
    swap.put(first + 2, sensor_type == 3 ? n : 1);
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const auto [v1, x1] = held(step - 1, at);
      const auto [v2, x2] = held(step - 2, at);
      const auto [v3, x3] = held(step - 3, at);
      swap.put(first + 4 + i, extrapolated(v1, v2, v3));
      swap.put(first + 4 + n + i, extrapolated(x1, x2, x3));
    }
  }

  double extrapolated(double a1, double a2, double a3) const {
    if (order == 1) return 2.0 * a1 - a2;
    if (order == 2) return 3.0 * a1 - 3.0 * a2 + a3;
    return a1;
  }
};

}  // namespace lac::test
