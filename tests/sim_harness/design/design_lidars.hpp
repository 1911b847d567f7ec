// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "sim_harness/lidar/lidar_params.hpp"

namespace lac::sim {

/// Without a probe volume; gates at distances along the axis.
inline LidarParams points_at(std::vector<LidarBeam> beams, std::vector<double> gates_m) {
  LidarParams lidar;
  lidar.scan.beams = std::move(beams);
  lidar.gates_m = std::move(gates_m);
  lidar.gates_along_beam = false;
  lidar.weighting.fwhm_m = 0.0;
  return lidar;
}

/// That of Guo et al. (2023).
inline LidarParams four_beams() {
  return load_lidar(std::filesystem::path(LAC_SOURCE_DIR) / "config/lidars/four_beam_pulsed.yaml");
}

}  // namespace lac::sim
