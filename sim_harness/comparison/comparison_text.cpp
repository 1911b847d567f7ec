// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/comparison_text.hpp"

#include <cmath>
#include <cstdio>
#include <numeric>

#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

constexpr int kDigits = 5;
constexpr double kKilo = 1e-3;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

TextTable table_of(const Comparison& c) {
  std::vector<std::string> header{"wind m/s", "pairs"};
  for (const QuantityChange& q : c.quantities) header.push_back(q.name);
  TextTable table(header);
  for (std::size_t i = 0; i < c.speeds_mps.size(); ++i) {
    std::vector<std::string> cells{number(c.speeds_mps[i]), std::to_string(c.pairs[i])};
    for (const QuantityChange& q : c.quantities) cells.push_back(change_text(q.at_speed[i]));
    table.add_row(cells);
  }
  const std::size_t pairs = std::accumulate(c.pairs.begin(), c.pairs.end(), std::size_t{0});
  std::vector<std::string> cells{"life", std::to_string(pairs)};
  for (const QuantityChange& q : c.quantities) cells.push_back(q.life ? change_text(q.life) : "-");
  table.add_row(cells);
  return table;
}

void add_to(std::string& list, const std::string& item) {
  list += (list.empty() ? "" : ", ") + item;
}

/// "significant at 12, 14 m/s; not significant at 95 % at 16 m/s".
std::string words_by_speed(const Comparison& c, const QuantityChange& q) {
  std::vector<std::pair<std::string, std::string>> speeds_of;  // verdict, list of speeds
  for (std::size_t i = 0; i < c.speeds_mps.size(); ++i) {
    const std::string verdict = q.at_speed[i] ? q.at_speed[i]->verdict : "no pair";
    auto found = speeds_of.begin();
    while (found != speeds_of.end() && found->first != verdict) ++found;
    if (found == speeds_of.end()) found = speeds_of.insert(found, {verdict, ""});
    add_to(found->second, number(c.speeds_mps[i]));
  }
  std::string text;
  for (const auto& [verdict, speeds] : speeds_of)
    text += (text.empty() ? "" : "; ") + verdict + " at " + speeds + " m/s";
  return text;
}

std::string words_of_life(const QuantityChange& q) {
  if (!q.life) return {};
  const Change& life = *q.life;
  std::string text = "; life " + format_significant(life.a, kDigits) + " -> " +
                     format_significant(life.b, kDigits) + ", " + format_change(life.relative);
  if (std::isfinite(life.relative_low)) {
    text +=
        " (" + format_change(life.relative_low) + " to " + format_change(life.relative_high) + ")";
  }
  text += ", " + life.verdict;
  if (q.annual_energy_a_kWh) {
    text += "; energy of a year " + format_significant(kKilo * *q.annual_energy_a_kWh, kDigits) +
            " -> " + format_significant(kKilo * *q.annual_energy_b_kWh, kDigits) + " MWh";
  }
  return text;
}

}  // namespace

std::string change_text(const std::optional<Change>& c) {
  if (!c) return "n/a";
  const double half = 0.5 * (c->relative_high - c->relative_low);
  if (!std::isfinite(half)) return format_change(c->relative) + " ?";
  std::string change = format_change(c->relative);
  change.erase(change.size() - 2);  // " %"
  const int decimals = std::abs(c->relative) < 0.01 ? 2 : 1;
  const std::string text = change + " ± " + format_value(100.0 * half, decimals) + " %";
  return c->significant ? text : "(" + text + ")";
}

std::vector<std::string> comparison_notes(const Comparison& c, const WindDistribution& wind) {
  std::size_t made = 0;
  for (const QuantityChange& q : c.quantities) {
    for (const auto& at : q.at_speed) made += at && std::isfinite(at->relative_low) ? 1 : 0;
  }
  const double covered = std::accumulate(c.share_of_time.begin(), c.share_of_time.end(), 0.0);
  std::vector<std::string> notes{
      "± : " + number(100.0 * c.confidence) +
          " % interval of the mean of the paired differences (Student), relative to the mean of A; "
          "in brackets: 0 lies inside; ?: one pair, no interval",
      "life: time at each speed after Weibull, scale " + format_value(wind.scale_mps, 2) +
          " m/s, shape " + number(wind.shape) + "; the bins cover " + percent_text(covered, 2) +
          " of the time, the rest counts as nothing; loads by their damage (sum p L^m)^(1/m)"};
  if (!c.del_text.empty()) notes.push_back("DEL: " + c.del_text);
  notes.push_back("of " + std::to_string(made) + " comparisons about " +
                  format_value((1.0 - c.confidence) * static_cast<double>(made), 1) +
                  " would be called significant by chance if nothing differed");
  if (c.unpaired_a + c.unpaired_b + c.left_out > 0) {
    notes.push_back("without a partner and not counted: " + std::to_string(c.unpaired_a) +
                    " runs of A, " + std::to_string(c.unpaired_b) +
                    " of B; not done and left out: " + std::to_string(c.left_out) + " rows");
  }
  return notes;
}

std::string comparison_text(const Comparison& c, const WindDistribution& wind) {
  std::string text =
      "change from A = " + c.a + " to B = " + c.b + "\n\n" + table_of(c).text() + "\n";
  for (const QuantityChange& q : c.quantities)
    text += q.name + " [" + q.unit + "]: " + words_by_speed(c, q) + words_of_life(q) + "\n";
  text += "\n";
  for (const std::string& note : comparison_notes(c, wind)) text += note + "\n";
  return text;
}

std::string comparison_csv(const Comparison& c) {
  std::string text = csv_line({"quantity", "unit", "wind_speed_mps", "pairs", "a", "b",
                               "relative_change", "relative_low", "relative_high", "verdict"});
  const auto add = [&](const QuantityChange& q, const std::string& speed, const Change& x) {
    text += csv_line({q.name, q.unit, speed, std::to_string(x.pairs), csv_number(x.a),
                      csv_number(x.b), csv_number(x.relative), csv_number(x.relative_low),
                      csv_number(x.relative_high), x.verdict});
  };
  for (const QuantityChange& q : c.quantities) {
    for (std::size_t i = 0; i < c.speeds_mps.size(); ++i)
      if (q.at_speed[i]) add(q, csv_number(c.speeds_mps[i]), *q.at_speed[i]);
    if (q.life) add(q, "life", *q.life);
  }
  return text;
}

}  // namespace lac::sim
