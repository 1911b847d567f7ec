// SPDX-License-Identifier: Apache-2.0
// Tables of runs: one row per run, columns of words and numbers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lac::sim {

/// The text of a .csv file, in memory.
class CsvTable {
 public:
  /// Comma-separated, a line of names first; cells with a comma, quote or line feed in quotes, a
  /// quote doubled. Throws lac::Error with file and line: cannot be read, no names, a row with
  /// another number of cells, a quote that is not closed.
  explicit CsvTable(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  std::size_t rows() const { return rows_.size(); }
  /// Names as they stand in the file, units included.
  const std::vector<std::string>& names() const { return names_; }
  /// By its name, with or without the unit in brackets behind it.
  std::optional<std::size_t> find(std::string_view name) const;
  /// The same; throws lac::Error with the nearest name that there is.
  std::size_t column(std::string_view name) const;

  const std::string& text(std::size_t row, std::size_t column) const { return rows_[row][column]; }
  /// NaN for an empty cell. Throws lac::Error with file, line and column if it is no number.
  double number(std::size_t row, std::size_t column) const;
  /// "file:line" of a row, for messages.
  std::string place(std::size_t row) const;

 private:
  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;
};

/// "TwrBsMyt_mean" of "TwrBsMyt_mean [kNm]".
std::string_view without_unit(std::string_view name);
/// "kNm" of "TwrBsMyt_mean [kNm]", empty if there is none.
std::string_view unit_in(std::string_view name);

/// One line with its line feed, cells quoted where they need it.
std::string csv_line(const std::vector<std::string>& cells);
/// The shortest text that reads back as the same number; empty for NaN.
std::string csv_number(double value);

}  // namespace lac::sim
