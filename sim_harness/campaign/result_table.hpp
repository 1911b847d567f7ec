// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "sim_harness/campaign/case_marker.hpp"
#include "sim_harness/campaign/study_cases.hpp"

namespace lac::sim {

/// Writes the results of a study as one .csv file, complete or not at all: a line of names, then
/// one row per case and controller in the order of the study. Columns: case, status (done, failed,
/// open), reason, one per range (its name; of a range that is a key, the last word of it, or all of
/// it if two would be the same), one per other key that is set, controller, what the loads
/// are (del_reference, del_rainflow), figures with units.
/// A case that is not done has one row without controller and figures. Equal results give equal
/// bytes. `markers`: one per case. Throws lac::Error.
void write_result_table(const std::filesystem::path& file, const Study& study,
                        const std::vector<StudyCase>& cases,
                        const std::vector<CaseMarker>& markers);

/// Throws lac::Error with line and key if a range would be named as another column.
void check_columns(const Study& study);

}  // namespace lac::sim
