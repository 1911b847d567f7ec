// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim_harness/campaign/study_file.hpp"

namespace lac::sim {

/// One case of a study: the base case and what it sets.
struct StudyCase {
  std::string name;                  // "mean_speed_mps-12_seed-1_stable": its choices
  std::vector<std::size_t> choices;  // one per range
  std::vector<std::string> overrides;
  std::filesystem::path folder;  // of its results
  std::string wind;              // what its wind comes from: cases that have it alike can share one
};

/// Every combination of the ranges that is not excluded, the last range fastest. Throws lac::Error
/// if a key is set in two places, two cases get one name, there are too many or none.
std::vector<StudyCase> study_cases(const Study& study);

/// Loads every case as a run would and fills in StudyCase::wind. Throws the first fault as
/// lac::Error, with the place in the study file if a key of it is wrong.
void check_cases(const Study& study, std::vector<StudyCase>& cases);

/// The case as one command for a shell: `lac run ... --mark`, with full paths.
std::string command_line(const Study& study, const StudyCase& c,
                         const std::filesystem::path& program);

}  // namespace lac::sim
