// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/config/input_text.hpp"

#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace lac::sim {

std::string key_of_input_line(std::string_view line) {
  const std::size_t value = line.find_first_not_of(" \t\r");
  const std::size_t mark = line.find('!');
  if (mark == std::string_view::npos || mark == value || line[value] == '#') return {};
  std::istringstream rest{std::string(line.substr(mark + 1))};
  std::string key;
  rest >> key;
  return key;
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw Error(path.string() + ": cannot be read");
  return text.str();
}

void require_other_file(const std::filesystem::path& path, const std::filesystem::path& made_from,
                        const std::string& what) {
  std::error_code ignored;
  if (!std::filesystem::equivalent(path, made_from, ignored)) return;
  throw Error(path.string() + ": is " + what +
              " and is not written over; give another folder (--output)");
}

}  // namespace lac::sim
