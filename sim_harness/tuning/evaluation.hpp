// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sim_harness/tuning/simplex_search.hpp"
#include "sim_harness/tuning/tuning_file.hpp"

namespace lac::sim {

/// A set of parameters and what came of it.
struct Evaluation {
  Point values;                 // one per parameter
  std::vector<double> figures;  // one per target, in the unit of the channel; empty after a problem
  std::vector<double> changes;  // relative to the baseline
  double violation = 0.0;       // relative change by which the worst condition is missed
  std::string problem;          // why it could not be flown; empty: it was

  bool meets_conditions() const { return problem.empty() && violation == 0.0; }
  /// Infinite where there was a problem, or a number is none.
  Score score(const std::vector<TuningTarget>& targets) const;
};

/// Of figures over the cases of a target: loads (_delM) the one that does their mean damage, others
/// their mean; of extremes that is what IEC 61400-1 (7.6.2) asks for of several realisations.
double over_cases(const std::string& figure, const std::vector<double>& of_cases);

/// A figure that is not finite, or a condition on a change that is not, is the problem of its
/// evaluation.
Evaluation evaluated(const Point& values, const std::vector<TuningTarget>& targets,
                     const std::vector<double>& figures, const std::vector<double>& baseline);

/// The best one by score, none if nothing could be flown: evaluations.size().
std::size_t best_of(const std::vector<Evaluation>& evaluations,
                    const std::vector<TuningTarget>& targets);

/// Which evaluations are on the Pareto front: no other one is at least as good in every target and
/// better in one. Those with a problem are not. Limits of conditions do not enter.
std::vector<bool> pareto_front(const std::vector<Evaluation>& evaluations,
                               const std::vector<TuningTarget>& targets);

}  // namespace lac::sim
