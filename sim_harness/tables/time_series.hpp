// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "sim_harness/output/recording.hpp"
#include "sim_harness/tables/text_reader.hpp"

namespace lac::sim {

/// Time series by the ending of the file, in any case: .outb, .out, .csv (or .txt, read like it).
/// Values are kept as float32. Throws lac::Error: another ending, or what the readers say.
Recording read_time_series(const std::filesystem::path& file,
                           MissingRows missing = MissingRows::kRefused);

/// The file itself, or the runs right in a folder, by name: .outb, .out and .csv, but not what is
/// beside a run, <name>.lac.* and <name>.wind.*; of files that differ in nothing but their ending
/// (a result as .outb and .csv) the first of these endings. Throws lac::Error if there is none, no
/// such file or folder, or the folder is that of a campaign (results.csv with cases).
std::vector<std::filesystem::path> time_series_of(const std::filesystem::path& file_or_folder);

}  // namespace lac::sim
