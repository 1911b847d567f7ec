// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/number_table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/error.hpp"
#include "core/plain_number.hpp"

namespace lac::sim {
namespace {

constexpr char kSeparators[] = " \t,\r";

[[noreturn]] void fail(const std::filesystem::path& file, int line, const std::string& problem) {
  throw Error(file.string() + ":" + std::to_string(line) + ": " + problem);
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::size_t begin = line.find_first_not_of(kSeparators);
  while (begin != std::string::npos) {
    const std::size_t end = std::min(line.find_first_of(kSeparators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kSeparators, end);
  }
  return words;
}

}  // namespace

std::vector<NumberRow> load_number_table(const std::filesystem::path& file, std::size_t fewest,
                                         std::size_t most, const std::string& columns) {
  std::ifstream in(file);
  if (!in) throw Error(file.string() + ": cannot be read");
  std::vector<NumberRow> rows;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    const std::vector<std::string> words = words_of(text);
    if (words.empty() || words.front().front() == '#' || words.front().front() == '!') continue;
    NumberRow row{line, {}};
    for (const std::string& word : words) {
      const std::optional<double> value = plain_number(without_plus(word));
      if (!value || !std::isfinite(*value)) {
        fail(file, line, "found '" + word + "', expected a number: " + columns);
      }
      row.values.push_back(*value);
    }
    const std::size_t wanted = rows.empty() ? 0 : rows.front().values.size();
    const std::size_t found = row.values.size();
    if (found < fewest || found > most || (wanted != 0 && found != wanted)) {
      fail(file, line,
           "found " + std::to_string(found) + " numbers, expected " + columns +
               (wanted != 0 ? ", as many in each line" : ""));
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty())
    throw Error(file.string() + ": found no line with numbers, expected " + columns);
  return rows;
}

}  // namespace lac::sim
