// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "sim_harness/comparison/life_table.hpp"

namespace lac::sim {
namespace {

struct Pair {
  const RunTable::Run* a;
  const RunTable::Run* b;
};
using PairsAtSpeed = std::map<double, std::vector<Pair>>;

PairsAtSpeed pair_up(const RunTable& a, const RunTable& b, Comparison& result) {
  std::map<std::string, std::size_t> partners;
  for (std::size_t i = 0; i < b.runs.size(); ++i) partners[b.runs[i].key] = i;
  PairsAtSpeed pairs;
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    const auto partner = partners.find(a.runs[i].key);
    if (partner == partners.end()) continue;
    pairs[a.runs[i].wind_mps].push_back({&a.runs[i], &b.runs[partner->second]});
    result.runs.push_back({i, partner->second});
  }
  const std::size_t count = result.runs.size();
  if (count == 0) {
    throw Error("no run of '" + a.name + "' (" + std::to_string(a.runs.size()) +
                ") has a partner of '" + b.name + "' (" + std::to_string(b.runs.size()) +
                "): runs are paired by their parameters or file names; --pair-by names columns");
  }
  result.unpaired_a = a.runs.size() - count;
  result.unpaired_b = b.runs.size() - count;
  return pairs;
}

/// Figures of the pairs at one speed that have both, to the power of m.
struct Values {
  std::vector<double> a, b;

  Values(const std::vector<Pair>& pairs, std::size_t in_a, std::size_t in_b, double m) {
    for (const Pair& p : pairs) {
      const double x = p.a->figures[in_a], y = p.b->figures[in_b];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      a.push_back(m == 1.0 ? x : std::pow(x, m));
      b.push_back(m == 1.0 ? y : std::pow(y, m));
    }
  }
};

Change change_of(const PairedDifference& d) {
  return {d.pairs,          d.mean_a,          d.mean_b,        d.relative_change(),
          d.relative_low(), d.relative_high(), d.significant(), d.verdict()};
}

/// The same of the mth roots.
Change root_of(Change c, double m) {
  const auto root = [m](double x) { return std::pow(std::max(x, 0.0), 1.0 / m); };
  c.a = root(c.a);
  c.b = root(c.b);
  for (double* r : {&c.relative, &c.relative_low, &c.relative_high})
    if (std::isfinite(*r)) *r = root(1.0 + *r) - 1.0;
  return c;
}

std::string common_del_text(const RunTable& a, const RunTable& b) {
  if (a.del_rule && b.del_rule && a.del_rule != b.del_rule) {
    throw Error("the damage-equivalent loads of A = '" + a.name + "' and B = '" + b.name +
                "' are of different conventions and do not compare: " + a.del_rule->text() +
                "; against " + b.del_rule->text() +
                "; make both tables with the same --reference and --rainflow");
  }
  const std::string text = del_text(a);
  return a.del_rule == b.del_rule ? text : "A: " + text + "; B: " + del_text(b);
}

class Comparer {
 public:
  Comparer(const RunTable& a, const RunTable& b, const PairsAtSpeed& pairs,
           const Comparison& result)
      : a_(a), b_(b), pairs_(pairs), result_(result) {}

  QuantityChange quantity(const std::string& name) const {
    const std::size_t in_a = figure_index(a_, name), in_b = figure_index(b_, name);
    QuantityChange q;
    q.name = name;
    q.unit = unit_in(a_.figures[in_a]);
    if (unit_in(b_.figures[in_b]) != q.unit) {
      throw Error(name + ": is in [" + q.unit + "] of '" + a_.name + "' and in [" +
                  std::string(unit_in(b_.figures[in_b])) + "] of '" + b_.name + "'");
    }
    std::vector<double> power_a, power_b;
    for (const auto& [speed_mps, pairs] : pairs_) {
      const Values v(pairs, in_a, in_b, 1.0);
      q.at_speed.emplace_back();
      if (v.a.empty()) continue;
      q.at_speed.back() = change_of(compare_pairs(v.a, v.b, result_.confidence));
      power_a.push_back(q.at_speed.back()->a);
      power_b.push_back(q.at_speed.back()->b);
    }
    if (is_extreme(name)) return q;
    q.life = life(in_a, in_b, exponent_of(name));
    const auto kilowatts = kilowatts_per_unit({name, q.unit});
    if (!q.life || !kilowatts || !name.ends_with("_mean")) return q;
    q.annual_energy_a_kWh = *kilowatts * annual_energy(power_a, result_.share_of_time);
    q.annual_energy_b_kWh = *kilowatts * annual_energy(power_b, result_.share_of_time);
    return q;
  }

 private:
  std::optional<Change> life(std::size_t in_a, std::size_t in_b, double m) const {
    std::vector<PairedDifference> parts;
    for (const auto& [speed_mps, pairs] : pairs_) {
      const Values v(pairs, in_a, in_b, m);
      if (v.a.empty()) return std::nullopt;
      parts.push_back(compare_pairs(v.a, v.b, result_.confidence));
    }
    double covered = 0.0;
    for (const double share : result_.share_of_time) covered += share;
    std::vector<double> weights = result_.share_of_time;
    if (m == 1.0)
      for (double& w : weights) w /= covered;
    const Change change = change_of(weighted_sum(parts, weights));
    return m == 1.0 ? change : root_of(change, m);
  }

  const RunTable& a_;
  const RunTable& b_;
  const PairsAtSpeed& pairs_;
  const Comparison& result_;
};

}  // namespace

Comparison compare_runs(const RunTable& a, const RunTable& b, const ComparisonOptions& options) {
  Comparison result;
  result.a = a.name;
  result.b = b.name;
  result.confidence = options.confidence;
  result.left_out = a.source == b.source ? a.left_out : a.left_out + b.left_out;
  const PairsAtSpeed pairs = pair_up(a, b, result);
  for (const auto& [speed_mps, at_speed] : pairs) {
    result.speeds_mps.push_back(speed_mps);
    result.pairs.push_back(at_speed.size());
  }
  result.share_of_time = bin_probabilities(options.wind, result.speeds_mps);
  const Comparer comparer(a, b, pairs, result);
  const std::vector<std::string> wanted =
      options.quantities.empty() ? usual_quantities({&a, &b}) : options.quantities;
  for (const std::string& name : wanted) result.quantities.push_back(comparer.quantity(name));
  if (std::ranges::any_of(wanted, is_load)) result.del_text = common_del_text(a, b);
  return result;
}

}  // namespace lac::sim
