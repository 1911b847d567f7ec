// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/lidar/mounting.hpp"
#include "sim_harness/lidar/platform_motion.hpp"
#include "sim_harness/lidar/range_weighting.hpp"
#include "sim_harness/lidar/scan_pattern.hpp"

namespace lac::sim {

/// A lidar on nacelle or spinner, looking up-wind.
struct LidarParams {
  ScanPattern scan;
  std::vector<double> gates_m;   // distance of the gate centres or foci, rising
  bool gates_along_beam = true;  // else the distances are along the viewing axis of the lidar
  RangeWeighting weighting;
  MountingParams mounting;
  PlatformMotion platform;  // of the case, not of the lidar's file
};

/// Keys: gates_m (unless every beam has its own), gates_along (beam or axis) and those of
/// read_scan_pattern, read_range_weighting, read_mounting. Throws lac::Error.
LidarParams read_lidar(YamlReader& in);

/// The same from a file of its own (config/lidars/).
LidarParams load_lidar(const std::filesystem::path& file);

/// One line for reports: "4 beams, 10 gates from 50 to 170 m, scan 1 s".
std::string describe(const LidarParams& lidar);

}  // namespace lac::sim
