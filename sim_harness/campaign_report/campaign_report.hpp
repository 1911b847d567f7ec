// SPDX-License-Identifier: Apache-2.0
// What a report of a campaign says: every row, the figures of each controller by wind speed and
// over a life, the paired comparisons, for all runs and for each class of them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sim_harness/campaign_report/result_rows.hpp"
#include "sim_harness/comparison/comparison.hpp"
#include "sim_harness/comparison/life_table.hpp"

namespace lac::sim {

struct CampaignReportOptions {
  /// The folder of a campaign, its table, or a table of `lac stats --csv`. Several tables: each
  /// holds one controller or names it.
  std::vector<std::filesystem::path> inputs;
  std::string baseline;  // all others are compared with it; empty: the first
  RunTableOptions runs;
  /// Names without unit of the quantities in the tables of comparisons; empty: the usual ones. The
  /// figures show all.
  std::vector<std::string> quantities;
  double confidence = 0.95;
  WindDistribution wind = WindDistribution::rayleigh(10.0);  // class I
  std::string title;                                         // empty: of the folder or file
};

/// The runs of one controller and where they stand among all rows.
struct ReportedController {
  std::string name;
  RunTable runs;
  std::vector<std::size_t> rows;  // of runs.runs
};

/// All runs, or those with one value of a parameter.
struct ReportedView {
  std::string name;                        // "all runs", "stability = stable"
  std::size_t column = ResultRows::kNone;  // of the parameter; kNone: all
  std::string value;
  std::vector<LifeTable> lives;  // one per controller; without speeds: no run of it here
  struct Versus {
    std::size_t a = 0;  // controllers
    std::size_t b = 0;
    Comparison comparison;
  };
  std::vector<Versus> comparisons;  // of the baseline with each other controller that pairs
};

struct CampaignReport {
  std::string title;
  ResultRows rows;
  std::vector<std::size_t> varied;              // columns that tell the rows apart
  std::vector<ReportedController> controllers;  // the baseline first
  std::vector<std::string> quantities;          // of lives and comparisons, without unit
  std::vector<std::string> shown;               // those in the tables
  std::vector<ReportedView> views;              // all runs first
  std::vector<std::string> notes;               // what could not be compared, and why
  WindDistribution wind;
  double confidence = 0.95;
};

/// Reads and computes all of it with compare_runs() and life_table(). Throws lac::Error: a file
/// that is no table, no run that is done, a controller that is not there.
CampaignReport campaign_report(const CampaignReportOptions& options);

}  // namespace lac::sim
