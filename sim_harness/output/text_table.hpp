// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace lac::sim {

/// A table in aligned columns for the terminal: numbers to the right, words to the left, a rule
/// under the header. Widths count characters of UTF-8 text, not bytes.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header);

  /// Throws lac::Error if the number of cells differs from the header's.
  void add_row(std::vector<std::string> cells);

  /// Every line ends in a line feed; no trailing blanks.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;  // the header first
};

/// Fixed point with these decimals; "n/a" for a value that is not finite.
std::string format_value(double value, int decimals);

/// Fixed point with at least so many significant digits: 12345.7, 1.2346, 0.0012346 for 5; "0";
/// "n/a" for a value that is not finite.
std::string format_significant(double value, int digits);

/// 0.123 as "+12.3 %", below one percent with two decimals; "n/a" for a value that is not finite.
std::string format_change(double relative_change);

}  // namespace lac::sim
