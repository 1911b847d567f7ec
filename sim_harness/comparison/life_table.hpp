// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_harness/analysis/lifetime.hpp"
#include "sim_harness/comparison/run_table.hpp"

namespace lac::sim {

/// One quantity of one controller at each wind speed and over a life.
struct LifeQuantity {
  std::string name;  // "TwrBsMyt_del4"
  std::string unit;
  /// Over the runs at each speed: the mean; of damage-equivalent loads (_delM) the load that does
  /// their mean damage; of extremes (_max, _min) the extreme. NaN without a run.
  std::vector<double> at_speed;
  /// Loads by damage, others weighted with the time within the bins; none of extremes, or if a
  /// speed has none.
  std::optional<double> life;
  std::optional<double> annual_energy_kWh;  // of a mean power, within the bins
};

struct LifeTable {
  std::string name;
  std::vector<double> speeds_mps;  // rising
  std::vector<double> share_of_time;
  std::vector<std::size_t> runs;
  std::vector<LifeQuantity> quantities;
  std::string del_text{};  // what its loads are; empty: it has none
};

/// Quantities by their names without unit. Throws lac::Error: one that is not there, no run.
LifeTable life_table(const RunTable& runs, const std::vector<std::string>& quantities,
                     const WindDistribution& wind);

/// The load's exponent: 4 of "TwrBsMyt_del4"; 1 of every other quantity.
double exponent_of(const std::string& quantity);
/// A damage-equivalent load.
bool is_load(const std::string& quantity);
/// What the loads of a table are, in words; that it is not known, if the table does not say.
std::string del_text(const RunTable& runs);
/// _min, _max or one of their times.
bool is_extreme(const std::string& quantity);
/// Where a quantity stands among the figures; throws lac::Error with the nearest one.
std::size_t figure_index(const RunTable& runs, const std::string& quantity);
/// The quantities that control engineers look at first, those that all tables have.
std::vector<std::string> usual_among(const std::vector<const RunTable*>& tables);
/// The same; throws lac::Error if there is none.
std::vector<std::string> usual_quantities(const std::vector<const RunTable*>& tables);

/// For the terminal: a row per wind speed and one for the life, then the conventions.
std::string life_text(const LifeTable& table, const WindDistribution& wind);

}  // namespace lac::sim
