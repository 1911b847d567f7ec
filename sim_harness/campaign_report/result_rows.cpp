// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign_report/result_rows.hpp"

#include <algorithm>
#include <map>

#include "core/error.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr const char* kTableColumn = "table";
constexpr const char* kTableOfCampaign = "results.csv";

void require_distinct_names(const std::vector<CsvTable>& tables) {
  std::map<std::string, fs::path> files;
  for (const CsvTable& table : tables) {
    const auto [found, is_new] = files.emplace(table_name(table.file()), table.file());
    if (is_new) continue;
    throw Error(table.file().string() + ": is called '" + found->first + "' as " +
                found->second.string() + "; several tables need names of their own");
  }
}

void add_table(const CsvTable& table, std::size_t number, bool named, const RunTableOptions& o,
               ResultRows& rows) {
  std::vector<std::size_t> place;
  for (const std::string& name : table.names()) {
    if (rows.column(name) == ResultRows::kNone) rows.columns.push_back(name);
    place.push_back(rows.column(name));
  }
  for (std::vector<std::string>& row : rows.cells) row.resize(rows.columns.size());
  rows.row_of_table[number].assign(table.rows(), ResultRows::kNone);
  for (const std::size_t row : chosen_rows(table, o)) {
    std::vector<std::string> cells(rows.columns.size());
    if (named) cells[0] = table_name(table.file());
    for (std::size_t c = 0; c < place.size(); ++c) cells[place[c]] = table.text(row, c);
    rows.row_of_table[number][row] = rows.cells.size();
    rows.cells.push_back(std::move(cells));
  }
}

/// For each row that is done the number of its value, in the order values come up.
std::vector<std::size_t> partition(const ResultRows& rows, std::size_t column) {
  const std::size_t status = rows.column("status");
  std::map<std::string, std::size_t> numbers;
  std::vector<std::size_t> parts;
  for (const std::vector<std::string>& row : rows.cells) {
    if (status != ResultRows::kNone && row[status] != "done") continue;
    parts.push_back(numbers.emplace(row[column], numbers.size()).first->second);
  }
  return parts;
}

}  // namespace

fs::path result_table_of(const fs::path& folder_or_file) {
  if (!fs::is_directory(folder_or_file)) return folder_or_file;
  const fs::path table = folder_or_file / kTableOfCampaign;
  if (fs::exists(table)) return table;
  throw Error(
      folder_or_file.string() + ": has no " + kTableOfCampaign +
      ", expected the folder of a campaign; `lac stats --csv` makes a table of time series");
}

std::string table_name(const fs::path& file) {
  if (file.filename() != kTableOfCampaign) return file.stem().string();
  return fs::weakly_canonical(file).parent_path().filename().string();
}

std::size_t ResultRows::column(const std::string& name) const {
  const auto found = std::ranges::find(columns, name);
  return found == columns.end() ? kNone : static_cast<std::size_t>(found - columns.begin());
}

ResultRows result_rows(const std::vector<CsvTable>& tables, const RunTableOptions& options) {
  ResultRows rows;
  rows.row_of_table.resize(tables.size());
  const bool named = tables.size() > 1;
  if (named) rows.columns.emplace_back(kTableColumn);
  require_distinct_names(tables);
  for (std::size_t i = 0; i < tables.size(); ++i) add_table(tables[i], i, named, options, rows);
  return rows;
}

std::vector<std::size_t> varied_columns(const ResultRows& rows, const RunTableOptions& options) {
  std::vector<std::size_t> columns;
  std::vector<std::vector<std::size_t>> partitions;
  const std::size_t controller = rows.column(options.controller_column);
  if (controller != ResultRows::kNone) partitions.push_back(partition(rows, controller));
  for (std::size_t c = 0; c < rows.columns.size(); ++c) {
    const std::string& name = rows.columns[c];
    if (c == controller || is_bookkeeping(name) || !unit_in(name).empty()) continue;
    std::vector<std::size_t> parts = partition(rows, c);
    const bool constant = std::ranges::all_of(parts, [](std::size_t p) { return p == 0; });
    if (constant || std::ranges::find(partitions, parts) != partitions.end()) continue;
    partitions.push_back(std::move(parts));
    columns.push_back(c);
  }
  return columns;
}

std::vector<std::string> values_in(const ResultRows& rows, std::size_t column) {
  std::vector<std::string> values;
  for (const std::vector<std::string>& row : rows.cells) {
    const std::string& value = row[column];
    if (!value.empty() && std::ranges::find(values, value) == values.end()) values.push_back(value);
  }
  return values;
}

}  // namespace lac::sim
