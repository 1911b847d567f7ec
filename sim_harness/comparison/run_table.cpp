// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/run_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/error.hpp"
#include "sim_harness/comparison/mean_wind.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::array<const char*, 5> kBookkeeping{"case", "status", "reason", kDelReferenceColumn,
                                                  kDelRainflowColumn};
constexpr const char* kFileColumn = "file";

bool is_figure(const std::string& name) {
  return !unit_in(name).empty();
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

double wind_speed(const CsvTable& table, std::size_t row, std::size_t column,
                  const RunTableOptions& o) {
  const double wind_mps = table.number(row, column);
  const std::string& name = table.names()[column];
  if (!std::isfinite(wind_mps)) {
    throw Error(table.place(row) + ": column '" + name + "': found '" + table.text(row, column) +
                "', expected the wind speed of the run");
  }
  return is_figure(name) ? binned(wind_mps, o.bin_mps) : wind_mps;
}

/// None if the table does not say.
std::optional<DelRule> del_rule_in(const CsvTable& table, std::size_t row) {
  const auto reference = table.find(kDelReferenceColumn), rainflow = table.find(kDelRainflowColumn);
  if (!reference || !rainflow) return std::nullopt;
  const std::string &r = table.text(row, *reference), &c = table.text(row, *rainflow);
  if (r.empty() && c.empty()) return std::nullopt;
  if (const auto rule = del_rule_of(r, c)) return rule;
  throw Error(table.place(row) + ": " + kDelReferenceColumn + ", " + kDelRainflowColumn +
              ": found '" + r + "', '" + c + "', expected 1hz or 2e6in20y, astm or four-point");
}

/// The rule of all runs so far is that of this row too.
void take_del_rule(const CsvTable& table, std::size_t row, RunTable& runs) {
  const auto rule = del_rule_in(table, row);
  if (runs.runs.empty()) runs.del_rule = rule;
  if (rule == runs.del_rule) return;
  throw Error(table.place(row) + ": its damage-equivalent loads are of another convention than " +
              runs.runs.front().place + " (columns " + kDelReferenceColumn + ", " +
              kDelRainflowColumn + "); --where " + kDelReferenceColumn +
              "=VALUE takes those of one");
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

bool is_bookkeeping(const std::string& column) {
  return column == kFileColumn || std::ranges::find(kBookkeeping, column) != kBookkeeping.end();
}

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
  result.source = table.file();
  std::vector<std::size_t> figure_columns;
  for (std::size_t i = 0; i < table.names().size(); ++i) {
    if (!is_figure(table.names()[i])) continue;
    figure_columns.push_back(i);
    result.figures.push_back(table.names()[i]);
  }
  const std::size_t wind =
      table.column(wind_column_of(table.file().string(), options.wind_column,
                                  [&](const char* name) { return table.find(name).has_value(); }));
  const std::vector<std::size_t> keys = key_columns(table, options);
  const auto controllers = table.find(options.controller_column);
  for (const std::size_t row : chosen_rows(table, options)) {
    if (!is_done(table, row)) {
      ++result.left_out;
      continue;
    }
    if (controllers && table.text(row, *controllers) != controller) continue;
    take_del_rule(table, row, result);
    RunTable::Run run{
        key_of(table, row, keys), wind_speed(table, row, wind, options), {}, table.place(row), row};
    for (const std::size_t c : figure_columns) run.figures.push_back(table.number(row, c));
    result.runs.push_back(std::move(run));
  }
  require_distinct(result);
  return result;
}

}  // namespace lac::sim
