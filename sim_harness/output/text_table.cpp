// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/text_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr std::size_t kGap = 2;

std::size_t width_of(const std::string& utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

/// Does the cell stand for a number, with or without a unit behind it?
bool is_number(const std::string& cell) {
  return cell.empty() || cell == "n/a" || cell.find_first_of("+-.0123456789") == 0;
}

std::string fixed_point(double value, int decimals, const char* sign) {
  char text[400];  // a double has up to 309 digits before the point
  std::snprintf(text, sizeof text, "%s%.*f", sign, decimals, value);
  return text;
}

}  // namespace

TextTable::TextTable(std::vector<std::string> header) : rows_{std::move(header)} {}

void TextTable::add_row(std::vector<std::string> cells) {
  if (cells.size() != rows_.front().size()) {
    throw Error("table: a row has " + std::to_string(cells.size()) + " cells, expected " +
                std::to_string(rows_.front().size()));
  }
  rows_.push_back(std::move(cells));
}

std::string TextTable::text() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::vector<bool> to_the_right(widths.size(), true);
  for (std::size_t r = 1; r < rows_.size(); ++r) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
      to_the_right[i] = to_the_right[i] && is_number(rows_[r][i]);
    }
  }
  std::string text;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string padding(widths[i] - width_of(rows_[r][i]), ' ');
      if (i > 0) line += std::string(kGap, ' ');
      line += to_the_right[i] ? padding + rows_[r][i] : rows_[r][i] + padding;
    }
    const std::size_t rule = width_of(line);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (r == 0) text += std::string(rule, '-') + "\n";
  }
  return text;
}

std::string format_value(double value, int decimals) {
  return std::isfinite(value) ? fixed_point(value, decimals, "") : "n/a";
}

std::string format_significant(double value, int digits) {
  if (value == 0.0) return "0";
  if (!std::isfinite(value)) return "n/a";
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  return fixed_point(value, std::clamp(digits - before_point, 0, 17), "");
}

std::string format_change(double relative_change) {
  if (!std::isfinite(relative_change)) return "n/a";
  const double percent = 100.0 * relative_change;
  const int decimals = std::abs(percent) < 1.0 ? 2 : 1;
  if (std::abs(percent) < 0.005) return "0.00 %";
  return fixed_point(percent, decimals, percent > 0.0 ? "+" : "") + " %";
}

}  // namespace lac::sim
