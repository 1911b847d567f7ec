// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace lac::sim {

/// Lines of a text file with their numbers, without line ends and byte order mark.
class TextLines {
 public:
  /// Throws lac::Error if the file cannot be opened.
  explicit TextLines(const std::filesystem::path& file);

  /// False at the end. Throws lac::Error for bytes that are no text.
  bool next();
  /// Valid until next().
  std::string_view text() const { return text_; }
  bool is_empty() const;
  std::size_t number() const { return number_; }

  /// Throw lac::Error "file:line: problem", of this line or another, or "file: problem".
  [[noreturn]] void fail(const std::string& problem) const { fail_at(number_, problem); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& problem) const;
  [[noreturn]] void fail_as_a_whole(const std::string& problem) const;

 private:
  std::filesystem::path file_;
  std::ifstream in_;
  std::string text_;
  std::size_t number_ = 0;
};

using Cells = std::vector<std::string_view>;

inline constexpr char kBlanks = ' ';  // as separator: any number of blanks and tabs

/// The cells of a line, blanks and quotes around them removed; they point into the line.
void split_cells(std::string_view line, char separator, Cells& cells);

}  // namespace lac::sim
