// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/input_template.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "sim_harness/config/input_text.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

std::string lower_key_of(std::string_view line) {
  std::string key = key_of_input_line(line);
  std::ranges::transform(key, key.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return key;
}

bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first != std::string::npos && (line[first] == '!' || line[first] == '#');
}

}  // namespace

std::string with_keys_replaced(std::string_view text, const std::vector<std::string>& keys,
                               const std::string& block) {
  std::vector<std::string> lines;
  std::size_t end_of_block = 0;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) {
    if (std::ranges::find(keys, lower_key_of(line)) == keys.end()) {
      lines.push_back(line);
      continue;
    }
    while (lines.size() > end_of_block && is_comment(lines.back())) lines.pop_back();
    if (end_of_block > 0) continue;
    std::istringstream made(block);
    for (std::string new_line; std::getline(made, new_line);) lines.push_back(new_line);
    end_of_block = lines.size();
  }
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return result;
}

std::string commented(const std::string& text) {
  std::istringstream in(text);
  std::string result;
  for (std::string line; std::getline(in, line);) result += "! " + line + "\n";
  return result;
}

std::string key_row(const std::vector<double>& values, int decimals,
                    const std::string& key_and_description) {
  std::string row;
  for (const double v : values) row += format_value(v, decimals) + " ";
  return row + "! " + key_and_description + "\n";
}

}  // namespace lac::sim
