// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lac::sim {

struct NumberRow {
  int line = 0;  // in the file, from 1
  std::vector<double> values;
};

/// Finite numbers (number_in()) in rows of equal length, separated by blanks, tabs or commas; empty
/// lines and those that begin with # or ! are comments. columns says what they mean and stands in
/// messages: "azimuth_deg elevation_deg". Throws lac::Error "<file>:<line>: found ..., expected
/// ...": no row, no number, too few or too many of them.
std::vector<NumberRow> load_number_table(const std::filesystem::path& file, std::size_t fewest,
                                         std::size_t most, const std::string& columns);

}  // namespace lac::sim
