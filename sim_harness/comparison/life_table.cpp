// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/life_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr int kDigits = 5;
constexpr double kKilo = 1e-3;

const char* const kUsual[] = {
    "RotSpeed_std",   "RotSpeed_max",   "GenPwr_mean",    "GenPwr_std",     "BldPitch1_travel",
    "TwrBsMyt_del4",  "TwrBsMyt_max",   "TwrBsMxt_del4",  "RootMyb1_del10", "RootMyc1_del10",
    "RootMxb1_del10", "RootMxc1_del10", "LSSTipMys_del4", "LSShftMxa_del4", "RotTorq_del4",
    "RotThrust_del4", "YawBrMyp_del4",  "TTDspFA_max"};

std::optional<std::size_t> find_figure(const RunTable& runs, std::string_view name) {
  for (std::size_t i = 0; i < runs.figures.size(); ++i)
    if (without_unit(runs.figures[i]) == name) return i;
  return std::nullopt;
}

std::optional<double> exponent_in(const std::string& quantity) {
  const std::size_t at = quantity.rfind("_del");
  if (at == std::string::npos) return std::nullopt;
  char* end = nullptr;
  const double m = std::strtod(quantity.c_str() + at + 4, &end);
  return *end == '\0' && m > 0.0 ? std::optional(m) : std::nullopt;
}

double combined(const std::vector<double>& values, const std::string& name) {
  if (values.empty()) return kNotANumber;
  if (name.ends_with("_max")) return *std::ranges::max_element(values);
  if (name.ends_with("_min")) return *std::ranges::min_element(values);
  return mean_load(values, exponent_of(name));
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

using RunsAtSpeed = std::map<double, std::vector<const RunTable::Run*>>;

LifeQuantity quantity_of(const RunTable& runs, const std::string& name, const RunsAtSpeed& at_speed,
                         const std::vector<double>& shares) {
  const std::size_t column = figure_index(runs, name);
  LifeQuantity q{name, std::string(unit_in(runs.figures[column])), {}, {}, {}};
  for (const auto& [speed_mps, at] : at_speed) {
    std::vector<double> values;
    for (const RunTable::Run* run : at)
      if (std::isfinite(run->figures[column])) values.push_back(run->figures[column]);
    q.at_speed.push_back(combined(values, name));
  }
  const bool complete = std::ranges::all_of(q.at_speed, [](double v) { return std::isfinite(v); });
  if (is_extreme(name) || !complete) return q;
  const double m = exponent_of(name);
  q.life = m == 1.0 ? std::inner_product(shares.begin(), shares.end(), q.at_speed.begin(), 0.0) /
                          sum_of(shares)
                    : lifetime_load(q.at_speed, shares, m);
  const auto kilowatts = kilowatts_per_unit({name, q.unit});
  if (kilowatts && name.ends_with("_mean"))
    q.annual_energy_kWh = *kilowatts * annual_energy(q.at_speed, shares);
  return q;
}

}  // namespace

double exponent_of(const std::string& quantity) {
  return exponent_in(quantity).value_or(1.0);
}

bool is_load(const std::string& quantity) {
  return exponent_in(quantity).has_value();
}

std::string del_text(const RunTable& runs) {
  return runs.del_rule ? runs.del_rule->text()
                       : std::string("convention not known, the table has no columns ") +
                             kDelReferenceColumn + ", " + kDelRainflowColumn;
}

bool is_extreme(const std::string& quantity) {
  return quantity.ends_with("_min") || quantity.ends_with("_max") || quantity.ends_with("_time");
}

std::size_t figure_index(const RunTable& runs, const std::string& quantity) {
  if (const auto found = find_figure(runs, quantity)) return *found;
  std::vector<std::string> known;
  for (const std::string& f : runs.figures) known.emplace_back(without_unit(f));
  throw Error("'" + runs.name + "' has no quantity '" + quantity + "'" +
              did_you_mean(quantity, known));
}

std::vector<std::string> usual_among(const std::vector<const RunTable*>& tables) {
  std::vector<std::string> names;
  for (const char* name : kUsual) {
    if (std::ranges::all_of(tables,
                            [&](const RunTable* t) { return find_figure(*t, name).has_value(); }))
      names.emplace_back(name);
  }
  return names;
}

std::vector<std::string> usual_quantities(const std::vector<const RunTable*>& tables) {
  std::vector<std::string> names = usual_among(tables);
  if (names.empty())
    throw Error("none of the usual quantities is there; --quantities names columns");
  return names;
}

LifeTable life_table(const RunTable& runs, const std::vector<std::string>& quantities,
                     const WindDistribution& wind) {
  RunsAtSpeed at_speed;
  for (const RunTable::Run& run : runs.runs) at_speed[run.wind_mps].push_back(&run);
  if (at_speed.empty()) throw Error("life: '" + runs.name + "' has no run");
  LifeTable table{runs.name, {}, {}, {}, {}};
  if (std::ranges::any_of(quantities, is_load)) table.del_text = del_text(runs);
  for (const auto& [speed_mps, at] : at_speed) {
    table.speeds_mps.push_back(speed_mps);
    table.runs.push_back(at.size());
  }
  table.share_of_time = bin_probabilities(wind, table.speeds_mps);
  for (const std::string& name : quantities)
    table.quantities.push_back(quantity_of(runs, name, at_speed, table.share_of_time));
  return table;
}

std::string life_text(const LifeTable& t, const WindDistribution& wind) {
  std::vector<std::string> header{"wind m/s", "runs", "time"};
  for (const LifeQuantity& q : t.quantities) header.push_back(q.name + " [" + q.unit + "]");
  TextTable table(header);
  for (std::size_t i = 0; i < t.speeds_mps.size(); ++i) {
    std::vector<std::string> cells{format_value(t.speeds_mps[i], 1), std::to_string(t.runs[i]),
                                   percent_text(t.share_of_time[i], 2)};
    for (const LifeQuantity& q : t.quantities)
      cells.push_back(format_significant(q.at_speed[i], kDigits));
    table.add_row(cells);
  }
  const std::size_t runs = std::accumulate(t.runs.begin(), t.runs.end(), std::size_t{0});
  std::vector<std::string> cells{"life", std::to_string(runs),
                                 percent_text(sum_of(t.share_of_time), 2)};
  for (const LifeQuantity& q : t.quantities)
    cells.push_back(q.life ? format_significant(*q.life, kDigits) : "-");
  table.add_row(cells);
  std::string text = t.name + "\n" + table.text();
  for (const LifeQuantity& q : t.quantities) {
    if (q.annual_energy_kWh)
      text += "energy of a year from " + q.name + ": " +
              format_significant(kKilo * *q.annual_energy_kWh, kDigits) + " MWh\n";
  }
  if (!t.del_text.empty()) text += "DEL: " + t.del_text + '\n';
  return text + "time after Weibull, scale " + format_value(wind.scale_mps, 2) + " m/s, shape " +
         format_value(wind.shape, 2) +
         "; loads by their damage (sum p mean(L^m))^(1/m), without damage outside the bins; others "
         "weighted with the time\n";
}

}  // namespace lac::sim
