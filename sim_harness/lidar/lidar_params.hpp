// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/vec3.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

/// Direction in the lidar's own frame L (core/lidar_block.hpp, beam_direction).
struct LidarBeam {
  double azimuth_rad = 0.0;    // about z, positive to the left of the viewing direction
  double elevation_rad = 0.0;  // positive upwards
};

/// What one range gate sees along its beam.
struct RangeWeighting {
  double fwhm_m = 30.0;  // full width at half maximum of the Gaussian; 0: the point itself
  int points = 9;        // of the quadrature over -3 ... +3 standard deviations
};

/// A pulsed lidar on the nacelle, looking up-wind.
struct LidarParams {
  std::vector<LidarBeam> beams;  // in the order in which they are taken
  std::vector<double> gates_m;   // distance of the gate centres, rising
  bool gates_along_beam = true;  // else the distances are along the viewing axis of the lidar
  double beam_time_s = 0.25;     // one beam after the other, each this long
  RangeWeighting weighting;
  Vec3 offset_m;          // of the lidar from the rotor centre, x down-wind
  double tilt_rad = 0.0;  // of the viewing axis, positive looks down

  double scan_time_s() const { return beam_time_s * static_cast<double>(beams.size()); }
};

/// Keys: beam_azimuth_deg, beam_elevation_deg, gates_m, gates_along (beam or axis), beam_time_s,
/// fwhm_m and, with defaults, weighting_points, offset_m, tilt_deg. Throws lac::Error.
LidarParams read_lidar(YamlReader& in);

/// The same from a file of its own (config/lidars/).
LidarParams load_lidar(const std::filesystem::path& file);

/// One line for reports: "4 beams, 10 gates from 50 to 170 m, scan 1 s".
std::string describe(const LidarParams& lidar);

}  // namespace lac::sim
