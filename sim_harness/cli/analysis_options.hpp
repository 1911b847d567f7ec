// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "sim_harness/cli/compare_command.hpp"
#include "sim_harness/cli/correlate_command.hpp"
#include "sim_harness/cli/report_command.hpp"
#include "sim_harness/cli/stats_command.hpp"

namespace lac::sim {

/// The command line of what reads results: `lac stats`, `lac life`, `lac compare`, `lac report`
/// and `lac correlate`.
class AnalysisOptions {
 public:
  /// Adds the commands; this must outlive the parsing.
  explicit AnalysisOptions(CLI::App& app);

  bool parsed() const {
    return stats_->parsed() || life_->parsed() || compare_->parsed() || report_->parsed() ||
           correlate_->parsed();
  }
  /// What was asked for. Throws lac::Error.
  void run(std::ostream& out) const;

 private:
  CLI::App* stats_;
  CLI::App* life_;
  CLI::App* compare_;
  CLI::App* report_;
  CLI::App* correlate_;
  StatsOptions stats_options_;
  LifeOptions life_options_;
  CompareOptions compare_options_;
  ReportOptions report_options_;
  CorrelateOptions correlate_options_;
};

}  // namespace lac::sim
