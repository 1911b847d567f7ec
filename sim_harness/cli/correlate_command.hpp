// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim_harness/analysis/inflow_windows.hpp"
#include "sim_harness/analysis/quality.hpp"
#include "sim_harness/cli/correlate_input.hpp"

namespace lac::sim {

struct CorrelateOptions {
  CorrelateInput input;
  std::vector<double>
      ranges_m;  // distance of each wind channel; empty: no decay, no speed of travel
  MovingWindow window;
  LagRange lags;
  ModeRule rule;                     // rated_power 0: the largest power there is
  double intensity_limit = 0.12;     // of the two classes of turbulence intensity
  double least_availability = 0.75;  // of a wind channel before filling, else an error
  double block_s = 75.0;             // of the coherence
  double confidence = 0.95;
  std::filesystem::path csv;      // all windows; empty: none
  std::filesystem::path spectra;  // spectra and coherence with bands; empty: none
};

/// `lac correlate`: correlation, delay, coherence, its decay and scales of wind speeds measured
/// up-wind and a load, by range, operating mode and turbulence intensity (G18). Throws lac::Error.
void correlate_command(const CorrelateOptions& options, std::ostream& out);

}  // namespace lac::sim
