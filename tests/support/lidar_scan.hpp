// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>

#include "core/lidar_block.hpp"

namespace lac::test {

/// A perfect point lidar that scans four beams in turn over a wind u(arrival time at the rotor):
/// every gate sees the wind that reaches the rotor distance/travel_mps later.
struct LidarScan {
  double beam_time_s = 0.25;
  double travel_mps = 16.0;
  double azimuth_rad = rad_from_deg(14.4);
  double elevation_rad = rad_from_deg(14.0);
  std::vector<double> gate_distance_m{60.0, 120.0, 180.0};  // along the rotor axis
  std::function<double(double)> wind_mps = [](double) { return 16.0; };

  /// In the order of config/lidars/four_beam_pulsed.yaml: left up, left down, right down, right up.
  Vec3 direction(int beam) const {
    return beam_direction(beam < 2 ? azimuth_rad : -azimuth_rad,
                          beam == 0 || beam == 3 ? elevation_rad : -elevation_rad);
  }

  LidarMeasurement measure(double time_s, int beam) const {
    LidarMeasurement m;
    m.time_s = time_s;
    m.beam_id = beam;
    m.beam_dir_L = direction(beam);
    m.position_I_m = {0.0, 0.0, 90.0};
    m.gate_count = static_cast<int>(gate_distance_m.size());
    for (std::size_t g = 0; g < gate_distance_m.size(); ++g) {
      const double u = wind_mps(time_s + gate_distance_m[g] / travel_mps);
      m.gates[g] = {gate_distance_m[g] / m.beam_dir_L.x, u * m.beam_dir_L.x, true, -10.0};
    }
    return m;
  }
};

}  // namespace lac::test
