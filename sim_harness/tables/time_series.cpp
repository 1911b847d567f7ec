// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/time_series.hpp"

#include <map>
#include <string>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim_harness/tables/outb_reader.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

enum class Format { kOutb, kOut, kCsv, kUnknown };  // preferred ones first

Format format_of(const fs::path& file) {
  const std::string ending = file.extension().string();
  if (equal_ignoring_case(ending, ".outb")) return Format::kOutb;
  if (equal_ignoring_case(ending, ".out")) return Format::kOut;
  if (equal_ignoring_case(ending, ".csv") || equal_ignoring_case(ending, ".txt"))
    return Format::kCsv;
  return Format::kUnknown;
}

/// What the chain and the harness write beside the recording of a run.
bool is_beside_a_run(const fs::path& file) {
  const std::string kind = file.stem().extension().string();
  return kind == ".lac" || kind == ".wind";
}

/// In a folder a .txt may be anything.
bool is_of_a_run(const fs::directory_entry& entry) {
  const fs::path& file = entry.path();
  return entry.is_regular_file() && format_of(file) != Format::kUnknown &&
         !equal_ignoring_case(file.extension().string(), ".txt") && !is_beside_a_run(file);
}

void refuse_campaign(const fs::path& folder) {
  const fs::path table = folder / "results.csv";
  if (!fs::exists(table) || !(fs::exists(folder / "cases.txt") || fs::exists(folder / "cases")))
    return;
  throw Error(folder.string() + ": is the folder of a campaign, expected one of time series; the " +
              "table of its runs is " + table.string() + " (for lac compare and lac life), the " +
              "time series are in " + (folder / "cases").string() + "/<case>");
}

}  // namespace

std::vector<fs::path> time_series_of(const fs::path& file_or_folder) {
  if (!fs::exists(file_or_folder))
    throw Error(file_or_folder.string() + ": no such file or folder");
  if (!fs::is_directory(file_or_folder)) return {file_or_folder};
  refuse_campaign(file_or_folder);
  std::map<fs::path, fs::path> by_stem;
  for (const fs::directory_entry& entry : fs::directory_iterator(file_or_folder)) {
    if (!is_of_a_run(entry)) continue;
    fs::path& chosen = by_stem[entry.path().stem()];
    if (chosen.empty() || format_of(entry.path()) < format_of(chosen)) chosen = entry.path();
  }
  if (by_stem.empty()) {
    throw Error(file_or_folder.string() +
                ": holds no time series, expected files in .outb, .out or .csv");
  }
  std::vector<fs::path> files;
  for (const auto& [stem, file] : by_stem) files.push_back(file);
  return files;
}

Recording read_time_series(const fs::path& file, MissingRows missing) {
  switch (format_of(file)) {
    case Format::kOutb:
      return read_outb(file);
    case Format::kOut:
      return read_out(file, missing);
    case Format::kCsv:
      return read_csv(file, missing);
    case Format::kUnknown:
      break;
  }
  throw Error(file.string() + ": ends in '" + file.extension().string() +
              "', expected time series in .outb, .out or .csv");
}

}  // namespace lac::sim
