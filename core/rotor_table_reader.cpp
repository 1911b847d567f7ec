// SPDX-License-Identifier: Apache-2.0
// The reader behind RotorTable::parse: goes by the comment lines, not by line numbers.
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/error.hpp"
#include "core/plain_number.hpp"
#include "core/rotor_table.hpp"
#include "core/units.hpp"

namespace lac {

namespace {

enum Section : std::size_t { kPitch, kTsr, kWind, kPower, kThrust, kTorque, kSectionCount };
constexpr std::array<const char*, kSectionCount> kSectionNames = {
    "Pitch angle vector", "TSR vector",         "Wind speed vector",
    "Power coefficient",  "Thrust coefficient", "Torque coefficient"};

struct Row {
  std::size_t line;
  std::vector<double> values;
};

/// One section of the file: the comment line that opens it and the lines of numbers below.
struct Block {
  std::size_t heading_line = 0;
  std::optional<std::size_t> announced;  // "36 entries" in the heading
  std::vector<Row> rows;
};

class Reader {
 public:
  explicit Reader(const std::string& file_name) : file_(file_name) {}

  void take_line(std::string_view line) {
    ++line_;
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) {
      line.remove_suffix(1);
    }
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos) return;
    line.remove_prefix(start);
    if (line[0] == '#' || line[0] == '!') {
      take_comment(line);
    } else {
      take_numbers(line);
    }
  }

  RotorTable table() const {
    const std::vector<double> pitch_deg = axis(kPitch);
    std::vector<double> pitch_rad(pitch_deg.size());
    std::transform(pitch_deg.begin(), pitch_deg.end(), pitch_rad.begin(), rad_from_deg);
    const std::vector<double> tsr = axis(kTsr);
    if (!blocks_[kTorque].rows.empty()) matrix(kTorque, tsr.size(), pitch_rad.size());
    return RotorTable(tsr, pitch_rad, matrix(kPower, tsr.size(), pitch_rad.size()),
                      matrix(kThrust, tsr.size(), pitch_rad.size()));
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& text) const {
    throw Error(file_ + ":" + std::to_string(line) + ": " + text);
  }

  void take_comment(std::string_view comment) {
    std::string lower(comment);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto says = [&](const char* a, const char* b) {
      return lower.find(a) != std::string::npos && lower.find(b) != std::string::npos;
    };
    if (says("pitch", "vector")) return open(kPitch, lower);
    if (says("tsr", "vector")) return open(kTsr, lower);
    if (says("wind speed", "vector")) return open(kWind, lower);
    if (says("power", "coefficient")) return open(kPower, lower);
    if (says("thrust", "coefficient")) return open(kThrust, lower);
    if (says("torque", "coefficient")) return open(kTorque, lower);
  }

  void open(Section section, const std::string& heading) {
    Block& block = blocks_[section];
    if (!block.rows.empty()) {
      fail(line_, std::string("\"") + kSectionNames[section] +
                      "\" a second time; the first is in line " +
                      std::to_string(block.heading_line));
    }
    block.heading_line = line_;
    block.announced = announced_entries(heading);
    current_ = section;
  }

  static std::optional<std::size_t> announced_entries(const std::string& heading) {
    const std::size_t word = heading.find(" entries");
    if (word == std::string::npos) return std::nullopt;
    std::size_t start = word;
    while (start > 0 && std::isdigit(static_cast<unsigned char>(heading[start - 1]))) --start;
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(heading.data() + start, heading.data() + word, count);
    return error == std::errc() ? std::optional(count) : std::nullopt;
  }

  void take_numbers(std::string_view line) {
    if (!current_) {
      fail(line_, "found \"" + std::string(line.substr(0, 40)) +
                      "\" before any heading; expected a line with # and \"Pitch angle vector\"");
    }
    Row row{line_, {}};
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t end = std::min(line.find_first_of(" \t,", i), line.size());
      if (end > i) row.values.push_back(number(line.substr(i, end - i)));
      i = end + 1;
    }
    blocks_[*current_].rows.push_back(std::move(row));
  }

  double number(std::string_view word) const {
    const std::optional<double> value = plain_number(without_plus(word));
    if (!value || !std::isfinite(*value)) {
      fail(line_, std::string("\"") + kSectionNames[*current_] + "\" has \"" + std::string(word) +
                      "\"; expected a number");
    }
    return *value;
  }

  const Block& require(Section section) const {
    const Block& block = blocks_[section];
    if (block.rows.empty()) {
      throw Error(file_ + ": no numbers for \"" + kSectionNames[section] +
                  "\"; expected a comment line with this text and the numbers below it");
    }
    return block;
  }

  /// A vector, on one line or several.
  std::vector<double> axis(Section section) const {
    const Block& block = require(section);
    std::vector<double> values;
    for (const Row& row : block.rows) {
      for (const double value : row.values) {
        if (!values.empty() && value <= values.back()) {
          fail(row.line, std::string("\"") + kSectionNames[section] + "\" does not rise: entry " +
                             std::to_string(values.size() + 1) + " is " + std::to_string(value) +
                             " after " + std::to_string(values.back()));
        }
        values.push_back(value);
      }
    }
    if (block.announced.value_or(values.size()) != values.size() || values.size() < 2) {
      fail(block.rows.front().line,
           std::string("\"") + kSectionNames[section] + "\" has " + std::to_string(values.size()) +
               " entries; expected " +
               (block.announced ? std::to_string(*block.announced) + " as its heading says"
                                : "2 or more"));
    }
    return values;
  }

  std::vector<double> matrix(Section section, std::size_t rows, std::size_t columns) const {
    const Block& block = require(section);
    if (block.rows.size() != rows) {
      fail(block.heading_line, std::string("\"") + kSectionNames[section] + "\" has " +
                                   std::to_string(block.rows.size()) + " rows; expected " +
                                   std::to_string(rows) + ", one per tip-speed ratio");
    }
    std::vector<double> values;
    for (const Row& row : block.rows) {
      if (row.values.size() != columns) {
        fail(row.line, std::string("\"") + kSectionNames[section] + "\" has " +
                           std::to_string(row.values.size()) + " numbers in this row; expected " +
                           std::to_string(columns) + ", one per pitch angle");
      }
      values.insert(values.end(), row.values.begin(), row.values.end());
    }
    return values;
  }

  std::string file_;
  std::size_t line_ = 0;
  std::optional<Section> current_;
  std::array<Block, kSectionCount> blocks_;
};

}  // namespace

RotorTable RotorTable::parse(std::string_view text, const std::string& file_name) {
  Reader reader(file_name);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.take_line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.table();
}

RotorTable RotorTable::load(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    throw Error(path.string() + ": cannot be read; expected a rotor table (Cp_Ct_Cq file)");
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return parse(text, path.string());
}

}  // namespace lac
