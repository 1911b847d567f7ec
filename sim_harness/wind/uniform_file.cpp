// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/uniform_file.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string_view>

#include "core/error.hpp"
#include "core/part_file.hpp"
#include "core/plain_number.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr std::size_t kMostColumns = 9;
constexpr std::size_t kLeastColumns = 8;
constexpr std::string_view kSeparators = " \t,\r";

struct Place {
  const std::filesystem::path& file;
  int line = 0;

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(file.string() + ":" + std::to_string(line) + ": " + problem);
  }
};

double number(std::string_view word, const Place& place) {
  const std::string_view digits = without_plus(word);
  const std::optional<double> value = plain_number(digits);
  if (!value || !std::isfinite(*value))
    place.fail("found '" + std::string(digits.substr(0, 40)) + "', expected a number");
  return *value;
}

std::vector<double> numbers(std::string_view line, const Place& place) {
  std::vector<double> values;
  for (std::size_t at = line.find_first_not_of(kSeparators); at != std::string_view::npos;
       at = line.find_first_not_of(kSeparators, at)) {
    const std::size_t end = std::min(line.find_first_of(kSeparators, at), line.size());
    if (line[at] == '!') break;
    values.push_back(number(line.substr(at, end - at), place));
    at = end;
  }
  return values;
}

UniformRow row_of(const std::vector<double>& v) {
  return {v[0],
          {v[1], rad_from_deg(v[2]), v[3], v[4], v[5], v[6], v[7],
           v.size() == kMostColumns ? rad_from_deg(v[8]) : 0.0}};
}

bool is_comment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kSeparators);
  return first == std::string_view::npos || line[first] == '!' || line[first] == '#';
}

void require_columns(std::size_t found, std::size_t expected, bool first_row, const Place& place) {
  if (found == expected || (first_row && found == kLeastColumns)) return;
  place.fail("found " + std::to_string(found) + " numbers, expected " +
             (first_row ? "8 or 9" : std::to_string(expected) + " as in the first row"));
}

void append(UniformRow row, UniformTable& table, const Place& place) {
  if (!table.rows.empty()) {
    const UniformRow& before = table.rows.back();
    if (!(row.time_s > before.time_s)) {
      place.fail("found time " + std::to_string(row.time_s) + " s, expected one after " +
                 std::to_string(before.time_s) + " s");
    }
    const double turn_rad = row.state.direction_rad - before.state.direction_rad;
    row.state.direction_rad -= 2.0 * kPi * std::round(turn_rad / (2.0 * kPi));
  }
  table.rows.push_back(row);
}

}  // namespace

UniformTable read_uniform_file(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw Error(file.string() + ": cannot be opened for reading");
  UniformTable table;
  Place place{file};
  std::size_t columns = kMostColumns;
  for (std::string line; std::getline(in, line);) {
    ++place.line;
    if (line.find('\0') != std::string::npos)
      place.fail("found bytes that are no text, expected a uniform wind file");
    if (is_comment(line)) continue;
    const std::vector<double> values = numbers(line, place);
    require_columns(values.size(), columns, table.rows.empty(), place);
    columns = values.size();
    append(row_of(values), table, place);
  }
  if (table.rows.empty()) throw Error(file.string() + ": found no row of numbers, expected one");
  return table;
}

void write_uniform_file(const std::filesystem::path& file, const UniformTable& table,
                        const std::string& description) {
  PartFile out(file);
  std::string text = "! " + description +
                     "\n!     Time        Speed    Direction     Vertical   Horizontal    Power-law"
                     "  Lin. vert.         Gust       Upflow"
                     "\n!      (s)        (m/s)        (deg)        (m/s)    shear (-)    shear (-)"
                     "   shear (-)        (m/s)        (deg)\n";
  for (const UniformRow& row : table.rows) {
    const UniformState& s = row.state;
    char line[200];
    const int size = std::snprintf(
        line, sizeof line, "%10.4f %12.6f %12.6f %12.6f %12.8f %12.8f %12.8f %12.6f %12.6f\n",
        row.time_s, s.speed_mps, deg_from_rad(s.direction_rad), s.vertical_mps, s.shear_y,
        s.shear_exponent, s.shear_z, s.gust_mps, deg_from_rad(s.upflow_rad));
    text.append(line, static_cast<std::size_t>(size));
  }
  out.write(text.data(), text.size());
  out.commit();
}

}  // namespace lac::sim
