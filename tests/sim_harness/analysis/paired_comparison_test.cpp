// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/paired_comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

// By hand: differences -1, -2, -3, mean -2, standard deviation 1, t(0.975, 2) = 4.302653 (scipy).
TEST(ComparePairs, ByHand) {
  const std::vector<double> a{10.0, 20.0, 30.0}, b{9.0, 18.0, 27.0};
  const PairedDifference d = compare_pairs(a, b);
  EXPECT_NEAR(d.difference(), -2.0, 1e-14);
  const double half = 4.302652729696142 / std::sqrt(3.0);
  EXPECT_NEAR(d.low, -2.0 - half, 1e-10);
  EXPECT_NEAR(d.high, -2.0 + half, 1e-10);
  EXPECT_NEAR(d.relative_change(), -0.1, 1e-15);
  EXPECT_NEAR(d.relative_low(), (-2.0 - half) / 20.0, 1e-11);
  EXPECT_FALSE(d.significant());
  EXPECT_EQ(d.verdict(), "not significant at 95 %");
  EXPECT_EQ(compare_pairs(a, b, 0.8).verdict(), "significant");
}

// What cannot be told is not told; equal results are no difference.
TEST(ComparePairs, EdgeCases) {
  const std::vector<double> one{1.0}, two{2.0};
  EXPECT_EQ(compare_pairs(one, two).verdict(), "one pair: no interval");
  EXPECT_FALSE(compare_pairs(one, two).significant());
  const std::vector<double> a{1.0, 2.0, 3.0};
  EXPECT_EQ(compare_pairs(a, a).verdict(), "not significant at 95 %");
  EXPECT_THAT(test::error_text([&] { compare_pairs(a, one); }),
              HasSubstr("3 values against 1, expected pairs"));
  EXPECT_THAT(test::error_text([] { compare_pairs({}, {}); }), HasSubstr("expected pairs"));
}

/// Six seeds: a large scatter that both share, a small one of their own.
struct Pairs {
  std::vector<double> a, b;
  Pairs(double change, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    for (int i = 0; i < 6; ++i) {
      const double wind = 100.0 + 20.0 * normal(random);
      a.push_back(wind + normal(random));
      b.push_back(wind + change + normal(random));
    }
  }
};

// 4000 experiments: the interval holds the true change in 95 % of them, within four standard
// deviations of a binomial (1.4 %). Where nothing changes it says "not significant" as often.
TEST(ComparePairs, CoverageOfTheInterval) {
  constexpr int kExperiments = 4000;
  const double bound = 4.0 * std::sqrt(0.95 * 0.05 / kExperiments);
  std::mt19937_64 random(3);
  int covered = 0, quiet = 0;
  for (int i = 0; i < kExperiments; ++i) {
    const Pairs changed(-2.0, random), same(0.0, random);
    const PairedDifference d = compare_pairs(changed.a, changed.b);
    covered += d.low <= -2.0 && -2.0 <= d.high;
    quiet += compare_pairs(same.a, same.b).verdict() == "not significant at 95 %";
  }
  EXPECT_NEAR(static_cast<double>(covered) / kExperiments, 0.95, bound);
  EXPECT_NEAR(static_cast<double>(quiet) / kExperiments, 0.95, bound);
}

// Pairing pays: a change of 2 in a scatter of 20 is found in most experiments, though the means of
// six unpaired values would scatter by 8.
TEST(ComparePairs, PowerOfPairing) {
  std::mt19937_64 random(4);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const Pairs p(-2.0, random);
    found += compare_pairs(p.a, p.b).significant();
  }
  EXPECT_GT(found, 250);
}

// The sum over wind speeds: one part with weight 1 is itself; weights act on means and intervals;
// the interval covers the weighted change as often as it says (Welch-Satterthwaite is approximate:
// a further half percent).
TEST(WeightedSum, Coverage) {
  std::mt19937_64 random(5);
  const Pairs first(1.0, random);
  const PairedDifference lone = compare_pairs(first.a, first.b);
  const PairedDifference same = weighted_sum(std::vector{lone}, std::vector{1.0});
  EXPECT_NEAR(same.low, lone.low, 1e-9);
  EXPECT_NEAR(same.mean_b, lone.mean_b, 1e-12);
  constexpr int kExperiments = 4000;
  int covered = 0;
  const std::vector<double> weights{0.2, 0.5, 0.1};
  for (int i = 0; i < kExperiments; ++i) {
    std::vector<PairedDifference> parts;
    for (const double change : {-2.0, 1.0, 3.0}) {
      const Pairs p(change, random);
      parts.push_back(compare_pairs(p.a, p.b));
    }
    const PairedDifference d = weighted_sum(parts, weights);
    covered += d.low <= 0.4 && 0.4 <= d.high;
  }
  EXPECT_NEAR(static_cast<double>(covered) / kExperiments, 0.95,
              4.0 * std::sqrt(0.95 * 0.05 / kExperiments) + 0.005);
}

// A wind speed with one seed leaves the sum without an interval.
TEST(WeightedSum, NeedsIntervals) {
  const std::vector<double> one{1.0}, pair{1.0, 2.0}, other{1.5, 2.75};
  const std::vector parts{compare_pairs(pair, other), compare_pairs(one, one)};
  const PairedDifference d = weighted_sum(parts, std::vector{0.5, 0.5});
  EXPECT_EQ(d.verdict(), "no interval");
  EXPECT_NEAR(d.difference(), 0.5 * 0.625, 1e-15);
}

}  // namespace
}  // namespace lac::sim
