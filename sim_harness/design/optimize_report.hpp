// SPDX-License-Identifier: Apache-2.0
// What `lac optimize` says and writes.
#pragma once

#include <string>
#include <vector>

#include "sim_harness/design/lidar_optimization.hpp"

namespace lac::sim {

/// For the terminal: the lidar as it is, then the best of each number of beams. as_it_is: k0.5 of
/// the design's own lidar.
std::string optimize_table(const DesignCase& design, const std::vector<OptimizedLidar>& found,
                           double as_it_is_radpm);

/// k0.5 over the angles, one row per layout.
std::string map_csv(const std::vector<OptimizedLidar>& found);

/// One page without other files: a heat map per number of beams, the best layout marked, layouts
/// that break a constraint crossed out.
std::string map_page(const DesignCase& design, const std::vector<OptimizedLidar>& found);

/// The best of all numbers of beams.
const OptimizedLidar& best_of(const std::vector<OptimizedLidar>& found);

}  // namespace lac::sim
