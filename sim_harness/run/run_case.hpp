// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "sim_harness/run/case_file.hpp"
#include "sim_harness/run/results.hpp"

namespace lac::sim {

/// What is left of a case in memory when it is done.
struct CaseResult {
  std::vector<FlightFigures> figures;        // one per controller
  std::vector<std::filesystem::path> files;  // written by the harness and the chains
};

/// Makes the wind, flies every controller in it, writes the files and prints the table to `out`;
/// warnings and progress go to standard error. Throws lac::Error; files of flights that were
/// completed stay.
CaseResult run_case(const Case& c, std::ostream& out);

}  // namespace lac::sim
