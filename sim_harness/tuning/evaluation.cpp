// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/input_file.hpp"
#include "sim_harness/analysis/lifetime.hpp"
#include "sim_harness/comparison/life_table.hpp"

namespace lac::sim {
namespace {

double missed_by(const TuningTarget& t, double change) {
  if (t.kind == TuningTarget::Kind::kAtLeast) return std::max(t.limit - change, 0.0);
  if (t.kind == TuningTarget::Kind::kAtMost) return std::max(change - t.limit, 0.0);
  return 0.0;
}

/// A condition is on the change; the objective needs the figure alone.
bool cannot_be_judged(const TuningTarget& t, double figure, double change) {
  const bool is_condition =
      t.kind == TuningTarget::Kind::kAtLeast || t.kind == TuningTarget::Kind::kAtMost;
  return !std::isfinite(figure) || (is_condition && !std::isfinite(change));
}

bool dominates(const Evaluation& a, const Evaluation& b, const std::vector<TuningTarget>& targets) {
  bool better = false;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const double gain = (b.figures[i] - a.figures[i]) * (targets[i].wants_less() ? 1.0 : -1.0);
    if (gain < 0.0) return false;
    better = better || gain > 0.0;
  }
  return better;
}

}  // namespace

Score Evaluation::score(const std::vector<TuningTarget>& targets) const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (!problem.empty()) return {kInfinite, kInfinite};
  const Score s{violation, targets.front().wants_less() ? figures.front() : -figures.front()};
  return std::isnan(s.violation) || std::isnan(s.objective) ? Score{kInfinite, kInfinite} : s;
}

double over_cases(const std::string& figure, const std::vector<double>& of_cases) {
  if (is_load(figure)) return mean_load(of_cases, exponent_of(figure));
  return std::reduce(of_cases.begin(), of_cases.end()) / static_cast<double>(of_cases.size());
}

Evaluation evaluated(const Point& values, const std::vector<TuningTarget>& targets,
                     const std::vector<double>& figures, const std::vector<double>& baseline) {
  Evaluation e{.values = values, .figures = figures, .changes = {}, .problem = {}};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    e.changes.push_back((figures[i] - baseline[i]) / std::abs(baseline[i]));
    if (cannot_be_judged(targets[i], figures[i], e.changes[i])) {
      return {.values = values,
              .figures = {},
              .changes = {},
              .problem = targets[i].figure + " is " + shortest(figures[i]) +
                         ", with the baseline " + shortest(baseline[i]) +
                         ": expected numbers to compare"};
    }
    e.violation = std::max(e.violation, missed_by(targets[i], e.changes[i]));
  }
  return e;
}

std::size_t best_of(const std::vector<Evaluation>& evaluations,
                    const std::vector<TuningTarget>& targets) {
  std::size_t best = evaluations.size();
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    if (!evaluations[i].problem.empty()) continue;
    if (best == evaluations.size() ||
        evaluations[i].score(targets) < evaluations[best].score(targets))
      best = i;
  }
  return best;
}

std::vector<bool> pareto_front(const std::vector<Evaluation>& evaluations,
                               const std::vector<TuningTarget>& targets) {
  std::vector<bool> on_front(evaluations.size());
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    const Evaluation& e = evaluations[i];
    on_front[i] =
        e.problem.empty() && std::ranges::none_of(evaluations, [&](const Evaluation& other) {
          return other.problem.empty() && dominates(other, e, targets);
        });
  }
  return on_front;
}

}  // namespace lac::sim
