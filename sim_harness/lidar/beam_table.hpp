// SPDX-License-Identifier: Apache-2.0
// Beams that a user lists one by one.
#pragma once

#include <filesystem>
#include <vector>

#include "core/input_file.hpp"
#include "sim_harness/lidar/scan_pattern.hpp"

namespace lac::sim {

/// Of azimuth and elevation from the viewing axis.
constexpr Range beam_angle_deg() {
  return Range::between(-80.0, 80.0);
}

/// Rising distances above zero, as many as the lidar block of the swap array carries at most.
std::vector<double> read_gates(YamlReader& in);

/// Key beams: a list of maps with azimuth_deg, elevation_deg and, if they differ from those of
/// the lidar, time_s and gates_m. Throws lac::Error.
std::vector<LidarBeam> read_beam_list(YamlReader& in);

/// Text file, a beam per line: azimuth_deg elevation_deg [time_s [focus_m]], in every line as many
/// numbers as in the first one; separated by blanks, tabs or commas; lines that begin with # or !
/// are comments. Throws lac::Error with file and line.
std::vector<LidarBeam> load_beam_table(const std::filesystem::path& file);

}  // namespace lac::sim
