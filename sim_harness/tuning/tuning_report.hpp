// SPDX-License-Identifier: Apache-2.0
// What `lac tune` says and writes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim_harness/tuning/evaluation.hpp"
#include "sim_harness/tuning/tuning_file.hpp"

namespace lac::sim {

struct TuningResult {
  const Tuning& tuning;
  std::vector<double> baseline;              // figures, one per target
  std::vector<Evaluation> evaluations = {};  // the grid first, then the refinement
  std::size_t grid = 0;                      // how many of them are the grid's
};

/// For the terminal: what was asked for, all evaluations, the Pareto front, the best.
std::string tuning_text(const TuningResult& result);

/// All evaluations as comma-separated text.
std::string evaluations_csv(const TuningResult& result);

/// Comments for the head of the tuned input file: where its values come from and what they gave.
std::string origin_comment(const TuningResult& result, std::size_t best);

}  // namespace lac::sim
