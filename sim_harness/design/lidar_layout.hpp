// SPDX-License-Identifier: Apache-2.0
// Where a lidar looks, in the few numbers that an optimisation moves.
#pragma once

#include <string>

#include "sim_harness/lidar/lidar_params.hpp"

namespace lac::sim {

/// Beams to the left, right, above and below of the viewing axis. By their number: 1 along the
/// axis; 2 left and right (azimuth); 4 in the corners (azimuth, elevation both ways), 5 with the
/// axis; 3, 6 and more spread evenly on the ellipse with these half axes, the first one half a step
/// from the top. Gates: equal steps from the first to the last one.
struct LidarLayout {
  int beams = 4;
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
  double first_gate_m = 0.0;
  double last_gate_m = 0.0;
  int gates = 1;
};

/// The beams and gates of the layout; all else, also the time that a beam takes, as the lidar has
/// it. Throws lac::Error (without a file) if its beams take different times.
LidarParams with_layout(LidarParams lidar, const LidarLayout& layout);

/// Between a beam and the viewing axis, the largest.
double largest_half_angle_rad(const LidarParams& lidar);

/// Height over ground of the lowest centre of a gate; the rotor centre at hub height.
double lowest_gate_m(const LidarParams& lidar, double hub_height_m);

/// A lidar file (config/lidars/) that is read as this lidar, angles and gates rounded to three
/// digits behind the point; fixed beams with common gates and times, on a platform at rest.
/// comment: for its head, lines without mark.
std::string lidar_file(const LidarParams& lidar, const std::string& comment);

}  // namespace lac::sim
