// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim_harness/tuning/evaluation.hpp"
#include "sim_harness/tuning/tuning_file.hpp"

namespace lac::sim {

struct TuningOptions {
  std::filesystem::path file;
  std::vector<std::string> overrides;   // "key=value", of the case
  std::filesystem::path output_folder;  // empty: results/<name>
  int jobs = 0;                         // flights at a time; 0: one per core
};

/// `lac tune`: flies the grid of parameters, then a simplex search from its best point within the
/// grid's borders; prints all evaluations, the Pareto front and the best point; writes
/// evaluations.csv and, if a point meets all conditions, the input file with the best one. False if
/// none does. An input file of before is removed first. Throws lac::Error; what was evaluated until
/// then, as after an interruption, is in evaluations.csv.
bool run_tuning(const TuningOptions& options, std::ostream& out);

/// Every combination of the values, the last parameter fastest.
std::vector<Point> grid_points(const std::vector<TuningParameter>& parameters);

}  // namespace lac::sim
