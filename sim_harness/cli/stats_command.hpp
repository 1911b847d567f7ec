// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim_harness/analysis/channel_figures.hpp"
#include "sim_harness/tables/text_reader.hpp"

namespace lac::sim {

struct StatsOptions {
  std::vector<std::filesystem::path> inputs;  // files, or folders for all series in them
  std::vector<std::string> channels;          // empty: all
  FigureOptions figures;
  MissingRows missing_rows = MissingRows::kRefused;
  std::filesystem::path csv;  // table with one row per file to write; empty: none
};

/// `lac stats`: the figures of each channel of each file, then the convention of the
/// damage-equivalent loads. Throws lac::Error naming the file.
void stats_command(const StatsOptions& options, std::ostream& out);

}  // namespace lac::sim
