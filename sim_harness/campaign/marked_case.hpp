// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim_harness/campaign/case_marker.hpp"
#include "sim_harness/run/run_case.hpp"

namespace lac::sim {

/// A case as a campaign and `lac run --mark` fly it.
struct MarkedCase {
  std::filesystem::path case_file;
  std::vector<std::string> overrides;
  std::filesystem::path folder;  // of its results
};

/// Mean, standard deviation, extremes, damage-equivalent loads and so on of every channel, the
/// run-in left out, with the digits that read back as the same number; before them del_reference
/// and del_rainflow, what the loads are.
CaseFigures figures_of(const Case& c, const CaseResult& result);

/// Flies the case and leaves `done` or `failed` in its folder; `shared`: its wind if that is there
/// already. Throws lac::Error, after `failed` is written unless the run was interrupted or another
/// process flies this case.
void fly_marked(const MarkedCase& order, const std::string& fingerprint, const CaseWind* shared,
                std::ostream& out);

}  // namespace lac::sim
