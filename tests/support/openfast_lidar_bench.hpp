// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/openfast_lidar.hpp"
#include "support/error_text.hpp"
#include "support/openfast_lidar_host.hpp"

namespace lac::test {

constexpr double kOpenFastStep_s = 0.00625;

inline OpenFastLidarParams with_order(int order, double interval_s = 0.25) {
  OpenFastLidarParams p;
  p.interpolation_order = order;
  p.measurement_interval_s = interval_s;
  p.rotor_position_x_m = -5.0;
  p.layout_at = "ldp.IN:1: LidarLayout";
  p.interval_at = "ldp.IN:2: MeasurementInterval";
  p.rotor_at = "ldp.IN:3: RotorPositionX";
  return p;
}

/// A reader and the array that a simulated OpenFAST fills for it.
struct OpenFastBench {
  explicit OpenFastBench(OpenFastLidarParams p)
      : lidar(std::move(p)), state(lidar.initial_state()) {}

  SwapView swap() { return {array.data(), kExtendedArraySize}; }
  bool fetch() {
    const double time_s = static_cast<double>(step++) * kOpenFastStep_s;
    notice.clear();
    const bool is_new = lidar.fetch(swap(), time_s, state, m, notice);
    if (notice.level() != 0) messages.emplace_back(notice.text());
    return is_new;
  }
  bool call() {
    host.fill(swap(), step);
    return fetch();
  }
  std::string start_error(double time_step_s = kOpenFastStep_s) {
    host.fill(swap(), 0);
    return error_text([&] { lidar.require(swap(), time_step_s, notice); });
  }
  void put(int offset, double value) { swap().put(kOpenFastLidarBlock.first + offset, value); }

  std::vector<float> array = std::vector<float>(kExtendedArraySize, 0.0f);
  OpenFastLidar lidar;
  OpenFastLidar::State state;
  OpenFastLidarHost host;
  LidarMeasurement m;
  Notice notice;
  long step = 0;
  std::vector<std::string> messages;
};

}  // namespace lac::test
