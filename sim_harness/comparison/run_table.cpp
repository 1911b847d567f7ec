// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/run_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim_harness/tables/time_series.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::array<const char*, 2> kWindParameters{"mean_speed_mps", "speed_mps"};
constexpr std::array<const char*, 5> kWindFigures{
    "RtVAvgxh_mean", "WindHubVelH_mean", "WindHubVelX_mean", "Wind1VelX_mean", "WindVelX_mean"};
constexpr std::array<const char*, 3> kBookkeeping{"case", "status", "reason"};
constexpr const char* kFileColumn = "file";

bool is_figure(const std::string& name) {
  return !unit_in(name).empty();
}

template <class Has>
std::string wind_column_of(const std::string& where, const RunTableOptions& o, Has&& has) {
  if (!o.wind_column.empty()) return o.wind_column;
  for (const char* name : kWindParameters)
    if (has(name)) return name;
  for (const char* name : kWindFigures)
    if (has(name)) return name;
  throw Error(where +
              ": has no mean wind speed, expected mean_speed_mps or RtVAvgxh_mean; --wind names "
              "another column");
}

double binned(double wind_mps, double bin_mps) {
  return bin_mps * std::round(wind_mps / bin_mps);
}

/// The rows that meet all conditions.
std::vector<std::size_t> chosen_rows(const CsvTable& table, const RunTableOptions& o) {
  std::vector<std::size_t> rows(table.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  for (const std::string& condition : o.where) {
    const std::size_t sign = condition.find('=');
    if (sign == std::string::npos)
      throw Error("--where '" + condition + "': expected COLUMN=VALUE");
    const std::size_t column = table.column(condition.substr(0, sign));
    const std::string value = condition.substr(sign + 1);
    std::erase_if(rows, [&](std::size_t row) { return table.text(row, column) != value; });
    if (rows.empty()) throw Error(table.file().string() + ": no row has " + condition);
  }
  return rows;
}

bool is_done(const CsvTable& table, std::size_t row) {
  const auto status = table.find("status");
  return !status || table.text(row, *status) == "done";
}

/// Does a column differ among the rows of one controller?
bool tells_winds_apart(const CsvTable& table, std::size_t column, const RunTableOptions& o) {
  const auto controllers = table.find(o.controller_column);
  std::map<std::string, std::string> first_of;
  for (const std::size_t row : chosen_rows(table, o)) {
    if (!is_done(table, row)) continue;
    const std::string controller = controllers ? table.text(row, *controllers) : "";
    const std::string& value = table.text(row, column);
    if (first_of.emplace(controller, value).first->second != value) return true;
  }
  return false;
}

std::vector<std::size_t> key_columns(const CsvTable& table, const RunTableOptions& o) {
  std::vector<std::size_t> columns;
  for (const std::string& name : o.pair_by) columns.push_back(table.column(name));
  if (!o.pair_by.empty()) return columns;
  for (std::size_t i = 0; i < table.names().size(); ++i) {
    const std::string& name = table.names()[i];
    const bool own = std::ranges::find(kBookkeeping, name) != kBookkeeping.end();
    if (own || name == o.controller_column || is_figure(name)) continue;
    if (tells_winds_apart(table, i, o)) columns.push_back(i);
  }
  return columns;
}

std::string key_of(const CsvTable& table, std::size_t row,
                   const std::vector<std::size_t>& columns) {
  std::string key;
  for (const std::size_t c : columns) {
    const std::string& text = table.text(row, c);
    key += table.names()[c] + "=";
    key += table.names()[c] == kFileColumn ? fs::path(text).stem().string() : text;
    key += ";";
  }
  return key;
}

/// What the chain and the harness write beside the recording of a run.
bool is_beside_a_run(const fs::path& file) {
  const std::string kind = file.stem().extension().string();
  return kind == ".lac" || kind == ".wind";
}

void require_distinct(const RunTable& runs) {
  std::map<std::string, std::string> places;
  for (const RunTable::Run& run : runs.runs) {
    const auto [found, is_new] = places.emplace(run.key, run.place);
    if (is_new) continue;
    throw Error(run.place + ": has the same parameters as " + found->second +
                "; --pair-by names the columns that tell the winds apart");
  }
}

}  // namespace

std::vector<std::string> controllers_in(const CsvTable& table, const RunTableOptions& options) {
  std::vector<std::string> names;
  const auto column = table.find(options.controller_column);
  for (std::size_t row = 0; column && row < table.rows(); ++row) {
    const std::string& name = table.text(row, *column);
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

RunTable runs_of_table(const CsvTable& table, const std::string& controller,
                       const RunTableOptions& options) {
  RunTable result;
  result.name = controller;
  std::vector<std::size_t> figure_columns;
  for (std::size_t i = 0; i < table.names().size(); ++i) {
    if (!is_figure(table.names()[i])) continue;
    figure_columns.push_back(i);
    result.figures.push_back(table.names()[i]);
  }
  const std::size_t wind = table.column(wind_column_of(
      table.file().string(), options, [&](const char* name) { return table.find(name); }));
  const std::vector<std::size_t> keys = key_columns(table, options);
  const auto controllers = table.find(options.controller_column);
  for (const std::size_t row : chosen_rows(table, options)) {
    if (!is_done(table, row)) {
      ++result.left_out;
      continue;
    }
    if (controllers && table.text(row, *controllers) != controller) continue;
    RunTable::Run run{key_of(table, row, keys), table.number(row, wind), {}, table.place(row)};
    if (is_figure(table.names()[wind])) run.wind_mps = binned(run.wind_mps, options.bin_mps);
    for (const std::size_t c : figure_columns) run.figures.push_back(table.number(row, c));
    result.runs.push_back(std::move(run));
  }
  require_distinct(result);
  return result;
}

RunTable runs_of_folder(const fs::path& folder, const FigureOptions& figures,
                        const RunTableOptions& options) {
  RunTable result;
  result.name = fs::weakly_canonical(folder).filename().string();
  for (const fs::path& file : time_series_of(folder)) {
    if (is_beside_a_run(file)) continue;
    try {
      const auto values = named_figures(channel_figures(read_time_series(file), figures), figures);
      const auto find = [&](std::string_view name) {
        return std::ranges::find(values, name, &NamedFigure::name);
      };
      const std::string wind = wind_column_of(
          file.string(), options, [&](const char* name) { return find(name) != values.end(); });
      if (find(wind) == values.end()) throw Error("has no figure '" + wind + "'");
      RunTable::Run run{
          file.stem().string(), binned(find(wind)->value, options.bin_mps), {}, file.string()};
      if (result.figures.empty())
        for (const NamedFigure& f : values) result.figures.push_back(f.header());
      for (const std::string& name : result.figures) {
        const auto found = find(without_unit(name));
        run.figures.push_back(found == values.end() ? std::nan("") : found->value);
      }
      result.runs.push_back(std::move(run));
    } catch (const Error& e) {
      const std::string text = e.what();
      throw Error(text.starts_with(file.string()) ? text : file.string() + ": " + text);
    }
  }
  return result;
}

}  // namespace lac::sim
