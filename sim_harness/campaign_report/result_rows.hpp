// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim_harness/comparison/run_table.hpp"
#include "sim_harness/tables/csv_table.hpp"

namespace lac::sim {

/// The table of a campaign's folder (results.csv in it), or the file itself. Throws lac::Error if
/// the folder has none.
std::filesystem::path result_table_of(const std::filesystem::path& folder_or_file);

/// What a table is called: its file without ending; of results.csv the folder.
std::string table_name(const std::filesystem::path& file);

/// The rows of one or several tables below each other, as text.
struct ResultRows {
  std::vector<std::string> columns;             // all that there are, in the order they come up
  std::vector<std::vector<std::string>> cells;  // a row's cell of a column it has not is empty
  std::vector<std::vector<std::size_t>> row_of_table;  // [table][row of it]: place in cells; kNone

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// The column's place; kNone if there is none.
  std::size_t column(const std::string& name) const;
};

/// Rows that meet the conditions (where). With several tables their names stand in the first
/// column, "table". Throws lac::Error if two have the same name.
ResultRows result_rows(const std::vector<CsvTable>& tables, const RunTableOptions& options);

/// A column that tells rows apart: what was flown. Not a figure, no bookkeeping, not the
/// controller's name; more than one value among rows that are done; and not the same partition as
/// one before it (a class by name and the key it sets).
std::vector<std::size_t> varied_columns(const ResultRows& rows, const RunTableOptions& options);

/// The values of a column among the rows in the order they come up.
std::vector<std::string> values_in(const ResultRows& rows, std::size_t column);

}  // namespace lac::sim
