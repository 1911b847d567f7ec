// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "sim_harness/run/case_file.hpp"
#include "sim_harness/run/report.hpp"
#include "sim_harness/wind/rotor_wind.hpp"

namespace lac::sim {

/// What is left of a case in memory when it is done.
struct CaseResult {
  std::vector<FlownController> flights;      // one per controller
  std::vector<FlightFigures> figures;        // the same
  std::vector<std::filesystem::path> files;  // written by the harness and the chains
};

/// Makes the wind, flies every controller in it, writes the files and prints the table to `out`;
/// warnings and progress go to standard error. Throws lac::Error; files of flights that were
/// completed stay.
CaseResult run_case(const Case& c, std::ostream& out);

/// The wind of a case, for those that differ from it in nothing the wind depends on.
struct CaseWind {
  std::unique_ptr<WindField> field;
  RotorWind rotor;
  std::string note = {};  // held_turbulence()
};

/// Throws lac::Error.
CaseWind make_case_wind(const Case& c);

/// run_case() in wind that is there already.
CaseResult fly_case(const Case& c, const CaseWind& wind, std::ostream& out);

}  // namespace lac::sim
