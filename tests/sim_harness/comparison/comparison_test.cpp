// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

RunTable table(const std::string& name, const std::vector<std::vector<double>>& rows) {
  RunTable t{name, {"GenPwr_mean [kW]", "TwrBsMyt_del4 [kNm]", "TwrBsMyt_max [kNm]"}, {}, 0};
  for (const auto& row : rows) {  // wind, seed, figures
    t.runs.push_back({std::to_string(row[0]) + ";" + std::to_string(row[1]),
                      row[0],
                      {row.begin() + 2, row.end()},
                      ""});
  }
  return t;
}

RunTable baseline() {
  return table(
      "fb",
      {{12, 1, 4000, 100, 7}, {12, 2, 4100, 110, 8}, {14, 1, 5000, 120, 9}, {14, 2, 5010, 130, 9}});
}

ComparisonOptions all() {
  ComparisonOptions o;
  o.quantities = {"GenPwr_mean", "TwrBsMyt_del4", "TwrBsMyt_max"};
  return o;
}

// By hand: at each speed two pairs, Student's factor for one degree of freedom 12.7062047.
TEST(CompareRuns, AtEachSpeed) {
  const RunTable lac = table(
      "lac",
      {{14, 2, 5010, 110, 8}, {14, 1, 5000, 108, 8}, {12, 1, 4010, 91, 7}, {12, 2, 4110, 100, 8}});
  const Comparison c = compare_runs(baseline(), lac, all());
  EXPECT_THAT(c.speeds_mps, ElementsAre(12.0, 14.0));
  EXPECT_THAT(c.pairs, ElementsAre(2U, 2U));
  const Change& load = *c.quantities[1].at_speed[0];  // differences -9 and -10
  EXPECT_NEAR(load.a, 105.0, 1e-12);
  EXPECT_NEAR(load.relative, -9.5 / 105.0, 1e-12);
  EXPECT_NEAR(load.relative_low, (-9.5 - 12.706204736 * 0.5) / 105.0, 1e-9);
  EXPECT_TRUE(load.significant);
  EXPECT_EQ(c.quantities[1].at_speed[1]->verdict, "not significant at 95 %");  // -12 and -20
  EXPECT_FALSE(c.quantities[2].life);  // no life of a maximum
}

// The life by hand: loads by their damage with the shares of the bins, powers by time, the energy
// of a year.
TEST(CompareRuns, OverALife) {
  const RunTable lac = table(
      "lac",
      {{12, 1, 4010, 91, 7}, {12, 2, 4110, 100, 8}, {14, 1, 5000, 108, 8}, {14, 2, 5010, 110, 8}});
  const Comparison c = compare_runs(baseline(), lac, all());
  const double p = c.share_of_time[0], q = c.share_of_time[1];
  const auto damage = [&](double a, double b, double d, double e) {
    return p * 0.5 * (std::pow(a, 4) + std::pow(b, 4)) +
           q * 0.5 * (std::pow(d, 4) + std::pow(e, 4));
  };
  const double a = std::pow(damage(100, 110, 120, 130), 0.25);
  const double b = std::pow(damage(91, 100, 108, 110), 0.25);
  const Change& load = *c.quantities[1].life;
  EXPECT_NEAR(load.a, a, 1e-10);
  EXPECT_NEAR(load.b, b, 1e-10);
  EXPECT_NEAR(load.relative, b / a - 1.0, 1e-12);
  EXPECT_LT(load.relative_low, load.relative);
  EXPECT_GT(load.relative_high, load.relative);
  EXPECT_EQ(load.pairs, 4U);
  EXPECT_NEAR(c.quantities[0].life->a, (p * 4050.0 + q * 5005.0) / (p + q), 1e-10);
  EXPECT_NEAR(*c.quantities[0].annual_energy_b_kWh, 8760.0 * (p * 4060.0 + q * 5005.0), 1e-6);
}

// Runs without a partner are counted; a figure that one of them lacks leaves its pair out.
TEST(CompareRuns, IncompleteRuns) {
  const RunTable lac = table(
      "lac",
      {{12, 1, NAN, 91, 7}, {12, 2, NAN, 100, 8}, {14, 2, 5010, 110, 8}, {16, 1, 5010, 110, 8}});
  const Comparison c = compare_runs(baseline(), lac, all());
  EXPECT_EQ(c.unpaired_a, 1U);
  EXPECT_EQ(c.unpaired_b, 1U);
  EXPECT_FALSE(c.quantities[0].at_speed[0]);
  EXPECT_EQ(c.quantities[0].at_speed[1]->verdict, "one pair: no interval");
  EXPECT_FALSE(c.quantities[0].life);
  EXPECT_FALSE(c.quantities[0].annual_energy_a_kWh);
}

// Nothing to pair, unknown quantities, other units.
TEST(CompareRuns, Faults) {
  const auto error_of = [](const RunTable& b, const ComparisonOptions& o) {
    return test::error_text([&] { compare_runs(baseline(), b, o); });
  };
  EXPECT_THAT(error_of(table("lac", {{16, 1, 1, 1, 1}}), all()),
              HasSubstr("no run of 'fb' (4) has a partner of 'lac' (1)"));
  ComparisonOptions o;
  o.quantities = {"TwrBsMyt_del"};
  EXPECT_THAT(error_of(baseline(), o),
              HasSubstr("'fb' has no quantity 'TwrBsMyt_del' (did you mean 'TwrBsMyt_del4'?)"));
  RunTable other = baseline();
  other.figures[0] = "GenPwr_mean [MW]";
  EXPECT_THAT(error_of(other, all()), HasSubstr("GenPwr_mean: is in [kW] of 'fb' and in [MW]"));
}

// Loads of two conventions do not compare, other figures do.
TEST(CompareRuns, ConventionOfLoads) {
  RunTable a = baseline(), b = baseline();
  a.del_rule = b.del_rule = DelRule{};
  EXPECT_EQ(compare_runs(a, b, all()).del_text, DelRule{}.text());
  b.del_rule->counting = RainflowRule::kFourPoint;
  EXPECT_THAT(test::error_text([&] { compare_runs(a, b, all()); }),
              HasSubstr("are of different conventions and do not compare"));
  ComparisonOptions power;
  power.quantities = {"GenPwr_mean"};
  EXPECT_EQ(compare_runs(a, b, power).del_text, "");
  b.del_rule.reset();
  EXPECT_THAT(compare_runs(a, b, all()).del_text, HasSubstr("; B: convention not known"));
}

// Rows that were not done: those of one table once, those of two together.
TEST(CompareRuns, LeftOut) {
  RunTable a = baseline(), b = baseline();
  a.left_out = 2;
  b.left_out = 3;
  a.source = "a.csv";
  b.source = "b.csv";
  EXPECT_EQ(compare_runs(a, b, all()).left_out, 5U);
  b.left_out = 2;
  b.source = a.source;
  EXPECT_EQ(compare_runs(a, b, all()).left_out, 2U);
}

}  // namespace
}  // namespace lac::sim
