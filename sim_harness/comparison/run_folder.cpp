// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "sim_harness/comparison/mean_wind.hpp"
#include "sim_harness/comparison/run_table.hpp"
#include "sim_harness/tables/time_series.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::array<const char*, 6> kOfOneWind{"_mean", "_std",      "_min",
                                                "_max",  "_min_time", "_max_time"};

/// All figures of a channel that varies, as one text; empty if it is not there or constant.
std::string wind_text(const RunTable& runs, const RunTable::Run& run, const std::string& channel) {
  std::string text;
  for (const char* what : kOfOneWind) {
    const auto is_it = [&](const std::string& f) { return without_unit(f) == channel + what; };
    const auto found = std::ranges::find_if(runs.figures, is_it);
    if (found == runs.figures.end()) return {};
    const double value = run.figures[static_cast<std::size_t>(found - runs.figures.begin())];
    if (!std::isfinite(value) || (what == kOfOneWind[1] && value == 0.0)) return {};
    text += csv_number(value) + ";";
  }
  return text;
}

void require_one_wind_each(const RunTable& runs) {
  for (const std::string name : kWindFigures) {
    const std::string channel = name.substr(0, name.rfind('_'));
    std::map<std::string, std::string> places;
    for (const RunTable::Run& run : runs.runs) {
      const std::string wind = wind_text(runs, run, channel);
      if (wind.empty()) continue;
      const auto [found, is_new] = places.emplace(wind, run.place);
      if (is_new) continue;
      throw Error(
          run.place + ": has the same wind (" + channel + ") as " + found->second +
          ": in a folder one file is one wind; results of several controllers of one run "
          "go into a folder each, under one name per wind, or into the table of a campaign");
    }
  }
}

RunTable::Run run_of_file(const fs::path& file, const FigureOptions& figures,
                          const RunTableOptions& options, std::vector<std::string>& names) {
  const auto values = named_figures(channel_figures(read_time_series(file), figures), figures);
  const auto find = [&](std::string_view name) {
    return std::ranges::find(values, name, &NamedFigure::name);
  };
  const std::string wind =
      wind_column_of(file.string(), options.wind_column,
                     [&](const char* name) { return find(name) != values.end(); });
  if (find(wind) == values.end()) throw Error("has no figure '" + wind + "'");
  const double wind_mps = find(wind)->value;
  if (!std::isfinite(wind_mps)) throw Error(wind + " is not finite, expected the wind speed");
  RunTable::Run run{file.stem().string(), binned(wind_mps, options.bin_mps), {}, file.string()};
  if (names.empty())
    for (const NamedFigure& f : values) names.push_back(f.header());
  for (const std::string& name : names) {
    const auto found = find(without_unit(name));
    run.figures.push_back(found == values.end() ? std::nan("") : found->value);
  }
  return run;
}

}  // namespace

RunTable runs_of_folder(const fs::path& folder, const FigureOptions& figures,
                        const RunTableOptions& options) {
  RunTable result;
  result.name = fs::weakly_canonical(folder).filename().string();
  result.source = folder;
  result.del_rule = figures.del_rule();
  for (const fs::path& file : time_series_of(folder)) {
    try {
      result.runs.push_back(run_of_file(file, figures, options, result.figures));
      result.runs.back().row = result.runs.size() - 1;
    } catch (const Error& e) {
      const std::string text = e.what();
      throw Error(text.starts_with(file.string()) ? text : file.string() + ": " + text);
    }
  }
  require_one_wind_each(result);
  return result;
}

}  // namespace lac::sim
