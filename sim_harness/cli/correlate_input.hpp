// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim_harness/analysis/inflow_windows.hpp"
#include "sim_harness/analysis/quality.hpp"

namespace lac::sim {

/// Where the series of `lac correlate` come from and what is done to them first.
struct CorrelateInput {
  std::vector<std::filesystem::path> files;  // of the same time; a channel is looked for in turn
  std::vector<std::string> winds;
  std::string load;
  std::string power = "GenPwr";
  std::string pitch = "BldPitch1";
  std::string companion;  // of every wind, e.g. its CNR; empty: none
  double companion_min = -17.0;
  double companion_max = 0.0;
  QualityRule wind_rule;  // applied to the winds
  double from_s = 0.0;    // earlier samples are left out
  double rate_hz = 4.0;   // everything is brought to it by means of neighbouring samples
};

struct CorrelatedSeries {
  std::vector<InflowSeries> of_wind;  // one per wind
  std::vector<QualityCount> quality;  // of each wind, at the rate of its file
  std::vector<std::size_t> dropped;   // for their companion
};

/// Rows that are missing count as gaps. Throws lac::Error: a channel that is in none of the files,
/// a rate that the step of a file has no whole number of samples for, files without common time.
CorrelatedSeries read_correlated(const CorrelateInput& input);

}  // namespace lac::sim
