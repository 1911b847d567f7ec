// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/number_table.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "sim_harness/tables/text_lines.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

constexpr std::string_view kSeparators = " \t,\r";

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(kSeparators);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kSeparators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kSeparators, end);
  }
  return words;
}

NumberRow row_of(const TextLines& lines, const std::vector<std::string_view>& words,
                 const std::string& columns) {
  NumberRow row{static_cast<int>(lines.number()), {}};
  for (const std::string_view word : words) {
    const std::optional<double> value = number_in(word);
    if (!value || !std::isfinite(*value))
      lines.fail("found '" + std::string(word) + "', expected a number: " + columns);
    row.values.push_back(*value);
  }
  return row;
}

}  // namespace

std::vector<NumberRow> load_number_table(const std::filesystem::path& file, std::size_t fewest,
                                         std::size_t most, const std::string& columns) {
  TextLines lines(file);
  std::vector<NumberRow> rows;
  while (lines.next()) {
    const std::vector<std::string_view> words = words_of(lines.text());
    if (words.empty() || words.front().front() == '#' || words.front().front() == '!') continue;
    NumberRow row = row_of(lines, words, columns);
    const std::size_t wanted = rows.empty() ? 0 : rows.front().values.size();
    const std::size_t found = row.values.size();
    if (found < fewest || found > most || (wanted != 0 && found != wanted)) {
      lines.fail("found " + std::to_string(found) + " numbers, expected " + columns +
                 (wanted != 0 ? ", as many in each line" : ""));
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty()) lines.fail_as_a_whole("found no line with numbers, expected " + columns);
  return rows;
}

}  // namespace lac::sim
