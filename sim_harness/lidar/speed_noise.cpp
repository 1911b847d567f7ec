// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/speed_noise.hpp"

#include <cmath>

namespace lac::sim {

SpeedNoiseParams read_speed_noise(YamlReader& in) {
  SpeedNoiseParams p;
  p.sigma_mps = in.number("sigma_mps", Range::not_negative());
  p.doubling_cnr_db = in.number("doubling_cnr_db", p.doubling_cnr_db, Range::between(-60.0, 60.0));
  return p;
}

double SpeedNoise::sigma_mps(double cnr_db) const noexcept {
  return params_.sigma_mps * (1.0 + std::pow(10.0, 0.1 * (params_.doubling_cnr_db - cnr_db)));
}

}  // namespace lac::sim
