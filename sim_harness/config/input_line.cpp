// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/config/input_line.hpp"

#include <sstream>

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

}  // namespace lac::sim
