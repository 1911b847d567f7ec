// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/csv_table.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string read_all(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(file.string() + ": cannot be opened for reading");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  return text;
}

/// Takes one row after the other off a text.
class RowScanner {
 public:
  RowScanner(const std::filesystem::path& file, std::string_view text) : file_(file), text_(text) {}

  bool at_end() const { return at_ == text_.size(); }
  std::size_t line() const { return line_; }

  std::vector<std::string> row() {
    std::vector<std::string> cells(1);
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '"') {
        take_quoted(cells.back());
      } else if (c == ',') {
        cells.emplace_back();
      } else if (c == '\n') {
        ++line_;
        break;
      } else if (c != '\r') {
        cells.back() += c;
      }
    }
    return cells;
  }

 private:
  void take_quoted(std::string& cell) {
    const std::size_t opened = line_;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') ++line_;
      if (c != '"') {
        cell += c;
      } else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
        cell += text_[at_++];
      } else {
        ++at_;
        return;
      }
    }
    throw Error(file_.string() + ":" + std::to_string(opened) + ": a quote is not closed");
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

bool is_empty(const std::vector<std::string>& cells) {
  return cells.size() == 1 && trimmed(cells[0]).empty();
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file) : file_(file) {
  const std::string text = read_all(file);
  RowScanner scanner(file_, text);
  names_ = scanner.row();
  if (is_empty(names_)) throw Error(file.string() + ":1: found no names of columns, expected them");
  while (!scanner.at_end()) {
    const std::size_t line = scanner.line();
    std::vector<std::string> cells = scanner.row();
    if (is_empty(cells)) continue;
    if (cells.size() != names_.size()) {
      throw Error(file.string() + ":" + std::to_string(line) + ": found " +
                  std::to_string(cells.size()) + " cells, expected " +
                  std::to_string(names_.size()) + " as in the line of names");
    }
    rows_.push_back(std::move(cells));
    lines_.push_back(line);
  }
}

std::optional<std::size_t> CsvTable::find(std::string_view name) const {
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (names_[i] == name) return i;
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (without_unit(names_[i]) == name) return i;
  return std::nullopt;
}

std::size_t CsvTable::column(std::string_view name) const {
  if (const auto found = find(name)) return *found;
  std::vector<std::string> known;
  for (const std::string& n : names_) known.emplace_back(without_unit(n));
  throw Error(file_.string() + ": has no column '" + std::string(name) + "'" +
              did_you_mean(name, known));
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  if (const auto value = number_in(rows_[row][column])) return *value;
  throw Error(place(row) + ": column '" + names_[column] + "': found '" + rows_[row][column] +
              "', expected a number");
}

std::string CsvTable::place(std::size_t row) const {
  return file_.string() + ":" + std::to_string(lines_[row]);
}

std::string_view without_unit(std::string_view name) {
  const std::size_t open = name.rfind(" [");
  return open == std::string_view::npos || !name.ends_with(']') ? name : name.substr(0, open);
}

std::string_view unit_in(std::string_view name) {
  const std::string_view bare = without_unit(name);
  if (bare.size() == name.size()) return {};
  return name.substr(bare.size() + 2, name.size() - bare.size() - 3);
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += ',';
    if (cells[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += cells[i];
      continue;
    }
    line += '"';
    for (const char c : cells[i]) line += c == '"' ? std::string(2, c) : std::string(1, c);
    line += '"';
  }
  return line + '\n';
}

std::string csv_number(double value) {
  if (std::isnan(value)) return {};
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

}  // namespace lac::sim
