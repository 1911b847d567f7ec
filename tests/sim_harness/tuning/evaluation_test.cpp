// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lac::sim {
namespace {

using Kind = TuningTarget::Kind;

TuningTarget target(const char* figure, Kind kind, double limit = 0.0) {
  TuningTarget t;
  t.figure = figure;
  t.kind = kind;
  t.limit = limit;
  return t;
}

const std::vector<TuningTarget> kTargets{target("TwrBsMyt_max", Kind::kMinimise),
                                         target("GenPwr_mean", Kind::kAtLeast, 0.0),
                                         target("TwrBsMyt_del4", Kind::kAtMost, 0.01)};
const std::vector<double> kBaseline{100.0, 50.0, 10.0};

Evaluation with(double extreme, double power, double load) {
  return evaluated({}, kTargets, {extreme, power, load}, kBaseline);
}
Evaluation failed() {
  return {.values = {}, .figures = {}, .changes = {}, .problem = "no"};
}

// Loads by damage: (mean of 1^4 and 2^4)^(1/4); extremes and powers by their mean.
TEST(OverCases, LoadsByDamage) {
  EXPECT_DOUBLE_EQ(over_cases("TwrBsMyt_del4", {1.0, 2.0}), std::pow(8.5, 0.25));
  EXPECT_DOUBLE_EQ(over_cases("TwrBsMyt_max", {1.0, 2.0}), 1.5);
  EXPECT_DOUBLE_EQ(over_cases("GenPwr_mean", {1.0, 2.0, 6.0}), 3.0);
}

// Changes count from the baseline, the worst condition is the violation; negative figures too.
TEST(Evaluation, ChangesAndViolation) {
  const Evaluation good = with(80.0, 50.0, 10.1);
  EXPECT_DOUBLE_EQ(good.changes[0], -0.2);
  EXPECT_NEAR(good.violation, 0.0, 1e-15);
  const Evaluation bad = with(60.0, 49.0, 10.5);
  EXPECT_NEAR(bad.violation, 0.04, 1e-12);  // load +5 % of 1 %; power -2 % of 0
  EXPECT_FALSE(bad.meets_conditions());
  const Evaluation less =
      evaluated({}, {target("TwrBsMyt_min", Kind::kMaximise)}, {-50.0}, {-100.0});
  EXPECT_DOUBLE_EQ(less.changes[0], 0.5);
}

// The best meets its conditions if any does; a failed one is never best.
TEST(Evaluation, Best) {
  EXPECT_EQ(best_of({failed(), with(60, 49, 10), with(90, 51, 10), with(85, 50, 10)}, kTargets),
            3U);
  EXPECT_EQ(best_of({with(60, 40, 10), failed(), with(90, 49, 10)}, kTargets), 2U);
  EXPECT_EQ(best_of({failed()}, kTargets), 1U);
  EXPECT_EQ(best_of({}, kTargets), 0U);
}

// What is no number meets no condition and wins nothing, not even as the first; a change from 0
// cannot be judged by a condition, but the objective may be 0 before.
TEST(Evaluation, NotANumber) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(with(60, nan, 10).meets_conditions());
  EXPECT_EQ(with(60, nan, 10).problem,
            "GenPwr_mean is nan, with the baseline 50: expected numbers to compare");
  EXPECT_FALSE(with(nan, 50, 10).problem.empty());
  EXPECT_FALSE(with(60, infinite, 10).problem.empty());
  const auto from = [](double extreme, double power) {
    return evaluated({}, kTargets, {80.0, 50.0, 10.0}, {extreme, power, 10.0});
  };
  EXPECT_FALSE(from(100.0, 0.0).meets_conditions());
  EXPECT_FALSE(from(100.0, nan).meets_conditions());
  EXPECT_TRUE(from(0.0, 50.0).meets_conditions());

  EXPECT_EQ(best_of({with(nan, 50, 10), with(90, 49, 10)}, kTargets), 1U);
  Evaluation none = with(80, 50, 10);
  none.violation = nan;
  EXPECT_EQ(best_of({none, with(90, 49, 10)}, kTargets), 1U);
  none = with(80, 50, 10);
  none.figures[0] = nan;
  EXPECT_EQ(best_of({none, with(90, 49, 10)}, kTargets), 1U);
}

// The objective that is to be large is the smaller score where it is larger.
TEST(Evaluation, Maximise) {
  const std::vector<TuningTarget> more{target("GenPwr_mean", Kind::kMaximise)};
  const Evaluation a = evaluated({}, more, {3.0}, {1.0}), b = evaluated({}, more, {2.0}, {1.0});
  EXPECT_EQ(best_of({b, a}, more), 1U);
}

// By hand: only the third is worse or equal in everything than another (the first). Equal ones stay
// both, failed ones never.
TEST(ParetoFront, ByHand) {
  const std::vector<Evaluation> e{with(80, 50, 10), with(70, 49, 10), with(81, 50, 10),
                                  with(90, 55, 12), failed(),         with(80, 50, 10)};
  EXPECT_EQ(pareto_front(e, kTargets), (std::vector<bool>{true, true, false, true, false, true}));
}

}  // namespace
}  // namespace lac::sim
