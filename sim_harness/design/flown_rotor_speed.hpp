// SPDX-License-Identifier: Apache-2.0
// Rotor speed as it was simulated, to be put beside the predicted one.
#pragma once

#include <filesystem>
#include <vector>

#include "sim_harness/analysis/spectrum.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

/// Results of `lac run`, seed by seed, feedback alone and lidar-assisted in the same wind.
struct FlownRuns {
  double mean_speed_mps = 0.0;  // one of the design's
  double run_in_s = 60.0;       // left out
  bool designed = true;         // the FFP input that this design writes; else its template
  std::vector<std::filesystem::path> feedback_only, assisted;  // .outb or .csv
};

/// Keys: mean_speed_mps, run_in_s, schedule (designed, template), feedback_only, lidar_assisted
/// (lists of files, from the design file's folder). Throws lac::Error.
FlownRuns read_flown_runs(YamlReader& in, const std::vector<double>& speeds_mps);

/// Mean over the files of the spectrum of RotSpeed [(rad/s)^2/Hz], blocks of a quarter of a record.
/// Throws lac::Error: no such channel, files of different steps, too short.
Spectrum flown_rotor_speed(const std::vector<std::filesystem::path>& files, double run_in_s);

}  // namespace lac::sim
