// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_harness/analysis/mode_coherence.hpp"

namespace lac::sim {

struct CoherenceOfMode {
  OperatingMode mode = OperatingMode::kMixed;
  std::optional<ModeCoherence> coherence;  // none: no two blocks
};

/// What was found of one wind speed and the load.
struct WindRelation {
  std::string wind;      // channel
  double range_m = 0.0;  // 0: not known
  InflowWindows windows;
  std::vector<CoherenceOfMode> modes;  // those with windows
};

/// One row per wind, operating mode and class of turbulence intensity (all, below, from the limit).
std::string relation_table(const std::vector<WindRelation>& relations, double intensity_limit);

/// One line per wind and mode: coherence with its band, where it falls to 0.4, decay.
std::string coherence_lines(const std::vector<WindRelation>& relations, double confidence);

/// All windows, one row each.
std::string windows_csv(const std::vector<WindRelation>& relations);

/// One row per wind, mode and frequency: both densities and the coherence with their bands.
std::string spectra_csv(const std::vector<WindRelation>& relations, double confidence);

}  // namespace lac::sim
