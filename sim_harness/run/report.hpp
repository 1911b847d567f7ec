// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_harness/output/html_report.hpp"
#include "sim_harness/run/case_file.hpp"
#include "sim_harness/run/results.hpp"

namespace lac::sim {

/// One flown controller: what was recorded outside, and what the chain wrote itself, if it did.
struct FlownController {
  std::string name;
  Recording recording;
  std::optional<Recording> chain_output;
};

/// Lidar REWS of a chain's own output file on the time of arrival at the rotor: the value that
/// came out at t with lead T stands for the wind that arrives around t + T - window / 2 (the mean
/// over one scan). Linear between arrivals, NaN where there is none. Channels LidarRews,
/// LidarRewsLead, LidarRewsValid (empty result if one of them is not in the file) and
/// LidarScanWindow (without it the window counts as zero).
std::vector<double> rews_at_arrival(const Recording& chain_output, const Recording& time_base);

/// The page of a case: results, traces and spectra of all flights.
HtmlReport make_report(const Case& c, const std::vector<FlownController>& flights,
                       const std::vector<ReportResult>& results);

}  // namespace lac::sim
