// SPDX-License-Identifier: Apache-2.0
// Two controllers on the same winds, wind speed by wind speed and over a life.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_harness/analysis/lifetime.hpp"
#include "sim_harness/analysis/paired_comparison.hpp"
#include "sim_harness/comparison/run_table.hpp"

namespace lac::sim {

/// What became of one quantity from controller A to B.
struct Change {
  std::size_t pairs = 0;
  double a = 0.0;
  double b = 0.0;
  double relative = 0.0;  // (b - a) / |a|, with its interval; NaN: none
  double relative_low = 0.0;
  double relative_high = 0.0;
  bool significant = false;
  std::string verdict;  // in words
};

struct QuantityChange {
  std::string name;  // "TwrBsMyt_del4"
  std::string unit;
  std::vector<std::optional<Change>> at_speed;  // none: no pair has this figure there
  /// Over the winds of a life, with each speed's share of the time. Damage-equivalent loads
  /// (_delM): the damages, load^M, are averaged and compared, then their Mth root taken. Other
  /// figures: means weighted with the shares. None for extremes (_min, _max), or if a speed has no
  /// pair.
  std::optional<Change> life;
  std::optional<double> annual_energy_a_kWh;  // of a mean power, within the bins
  std::optional<double> annual_energy_b_kWh;
};

/// Two runs in the same wind, by their places in the tables of A and B.
struct RunPair {
  std::size_t a = 0;
  std::size_t b = 0;
};

struct Comparison {
  std::string a, b;
  double confidence = 0.95;
  std::vector<double> speeds_mps;     // rising
  std::vector<double> share_of_time;  // of each
  std::vector<std::size_t> pairs;     // at each
  std::vector<RunPair> runs;          // all pairs, in the order of A
  std::vector<QuantityChange> quantities;
  std::size_t unpaired_a = 0;  // runs without a partner
  std::size_t unpaired_b = 0;
  std::size_t left_out = 0;  // rows of runs that were not done, of one table once
  std::string del_text;      // what the loads of both are; empty: none compared
};

struct ComparisonOptions {
  std::vector<std::string> quantities;  // names without unit; empty: the usual ones that there are
  double confidence = 0.95;
  WindDistribution wind = WindDistribution::rayleigh(10.0);  // class I
};

/// Pairs runs by their keys; the wind speed is that of A's run. Throws lac::Error: no pair at all,
/// a quantity that is not there, figures with different units, loads of different rules.
Comparison compare_runs(const RunTable& a, const RunTable& b, const ComparisonOptions& options);

}  // namespace lac::sim
