// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

/// Direction in the lidar's own frame L (core/lidar_block.hpp, beam_direction).
struct LidarBeam {
  double azimuth_rad = 0.0;     // about z, positive to the left of the viewing axis
  double elevation_rad = 0.0;   // positive upwards
  double time_s = 0.0;          // how long it accumulates; 0: beam_time_s of the scan
  std::vector<double> gates_m;  // of this beam alone; empty: those of the lidar
};

/// Which way a lidar looks, and when. Beams are taken in their order, again and again.
///
/// Sequential: beam_time_s (or its own time_s) for each, beam_pause_s between two, scan_pause_s
/// after the last. Simultaneous: all accumulate together for beam_time_s, then scan_pause_s.
struct ScanPattern {
  std::vector<LidarBeam> beams;
  double beam_time_s = 0.25;
  double beam_pause_s = 0.0;
  double scan_pause_s = 0.0;
  bool simultaneous = false;
  /// The wind is that at the end of the beam time (1), or the mean of this many instants in the
  /// middle of as many equal parts of it.
  int samples_per_beam = 1;

  double time_of_s(const LidarBeam& beam) const {
    return beam.time_s > 0.0 ? beam.time_s : beam_time_s;
  }
  /// From one scan to the next, pauses included.
  double scan_time_s() const;
  /// Mean, from one measurement to the next.
  double interval_s() const { return scan_time_s() / static_cast<double>(beams.size()); }
};

/// A circle about the viewing axis, as seen along it.
struct CircularScan {
  double half_angle_rad = 0.0;  // between beam and axis
  int points = 1;               // of one turn, the beam rests in each
  double start_rad = 0.0;       // of the first point, from the top, in the direction of turning
  bool clockwise = true;
};
std::vector<LidarBeam> beams_on_circle(const CircularScan& scan);

/// Keys: scan (fixed, circle, table), and of it
///   fixed   beam_azimuth_deg, beam_elevation_deg, beam_time_s
///   circle  cone_half_angle_deg, points_per_turn, turn_time_s, direction (clockwise,
///           counter_clockwise), start_deg
///   table   beams (list of maps: azimuth_deg, elevation_deg, time_s, gates_m) or beam_file (a
///           line per beam: azimuth_deg elevation_deg [time_s [focus_m]]), beam_time_s
/// and, with defaults, beams_taken (in_turn, at_once), beam_pause_s, scan_pause_s,
/// samples_per_beam. Throws lac::Error.
ScanPattern read_scan_pattern(YamlReader& in);

}  // namespace lac::sim
