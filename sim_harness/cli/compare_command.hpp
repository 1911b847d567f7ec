// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim_harness/comparison/comparison.hpp"

namespace lac::sim {

struct CompareOptions {
  /// A table (.csv) with two controllers, two tables, or two folders of time series.
  std::vector<std::filesystem::path> inputs;
  std::string baseline;  // controller A; empty: the first of one table, the only one of two
  std::string against;   // controller B; empty: the second of one table
  RunTableOptions runs;
  FigureOptions figures;  // of folders
  ComparisonOptions comparison;
  std::filesystem::path csv;  // table to write; empty: none
};

/// `lac compare`: what differs between two controllers on the same winds, and whether it is
/// significant. Throws lac::Error.
void compare_command(const CompareOptions& options, std::ostream& out);

struct LifeOptions {
  std::filesystem::path input;  // a table (.csv) or a folder of time series
  std::string controller;       // of a table; empty: the only one
  RunTableOptions runs;
  FigureOptions figures;  // of a folder
  std::vector<std::string> quantities;
  WindDistribution wind = WindDistribution::rayleigh(10.0);  // class I
};

/// `lac life`: one controller's figures at each wind speed and over a life. Throws lac::Error.
void life_command(const LifeOptions& options, std::ostream& out);

}  // namespace lac::sim
