// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "sim_harness/cli/wind_command.hpp"

namespace lac::sim {

/// The command line of `lac wind`: its four commands with their options.
class WindOptions {
 public:
  /// Adds the commands; this must outlive the parsing.
  explicit WindOptions(CLI::App& app);

  bool parsed() const { return wind_->parsed(); }
  /// What was asked for. Returns the exit code: 1 if a check failed. Throws lac::Error.
  int run(std::ostream& out) const;

 private:
  CLI::App* wind_;
  CLI::App* make_;
  CLI::App* convert_;
  CLI::App* stats_;
  CLI::App* check_;
  WindConvertOptions make_options_;
  WindConvertOptions convert_options_;
  WindStatsOptions stats_options_;
  WindCheckOptions check_options_;
};

}  // namespace lac::sim
