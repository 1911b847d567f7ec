// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/life_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

RunTable runs() {
  RunTable t{"fb", {"GenPwr_mean [MW]", "TwrBsMyt_del4 [kNm]", "RotSpeed_max [rpm]"}, {}, 0};
  const double rows[][4] = {{14, 5, 120, 13.5}, {12, 4, 100, 13}, {12, 4.2, 110, 13.2}};
  for (const auto& r : rows) t.runs.push_back({"", r[0], {r[1], r[2], r[3]}, ""});
  return t;
}

// By hand: powers by time, loads by damage, extremes as they are.
TEST(LifeTable, ByHand) {
  const WindDistribution wind = WindDistribution::rayleigh(8.5);
  const LifeTable t = life_table(runs(), {"RotSpeed_max", "GenPwr_mean", "TwrBsMyt_del4"}, wind);
  EXPECT_THAT(t.speeds_mps, ElementsAre(12.0, 14.0));
  EXPECT_THAT(t.runs, ElementsAre(2U, 1U));
  ASSERT_EQ(t.quantities.size(), 3U);
  const double p = wind.probability_below(13.0) - wind.probability_below(11.0);
  const double q = wind.probability_below(15.0) - wind.probability_below(13.0);
  const LifeQuantity &speed = t.quantities[0], &power = t.quantities[1], &load = t.quantities[2];
  EXPECT_EQ(speed.name, "RotSpeed_max");
  EXPECT_THAT(speed.at_speed, ElementsAre(13.2, 13.5));
  EXPECT_FALSE(speed.life);
  EXPECT_NEAR(*power.life, (4.1 * p + 5.0 * q) / (p + q), 1e-12);
  EXPECT_NEAR(*power.annual_energy_kWh, 8760e3 * (4.1 * p + 5.0 * q), 1e-5);
  const double damage = 0.5 * (std::pow(100, 4) + std::pow(110, 4));
  EXPECT_NEAR(load.at_speed[0], std::pow(damage, 0.25), 1e-10);
  EXPECT_NEAR(*load.life, std::pow(p * damage + q * std::pow(120, 4), 0.25), 1e-10);
}

// The text says which winds and how loads are put together; a figure that is missing has no life.
TEST(LifeTable, Text) {
  RunTable incomplete = runs();
  incomplete.runs[0].figures[1] = NAN;
  const WindDistribution wind = WindDistribution::rayleigh(10.0);
  const LifeTable t = life_table(incomplete, {"TwrBsMyt_del4", "GenPwr_mean"}, wind);
  const std::string text = life_text(t, wind);
  EXPECT_THAT(text, HasSubstr("TwrBsMyt_del4 [kNm]"));
  EXPECT_THAT(text, HasSubstr("n/a"));
  EXPECT_THAT(text, HasSubstr("energy of a year from GenPwr_mean: "));
  EXPECT_THAT(text, HasSubstr("scale 11.28 m/s, shape 2.00; loads by their damage"));
  EXPECT_FALSE(t.quantities[0].life);
}

// What the loads are is said where there are loads.
TEST(LifeTable, ConventionOfLoads) {
  RunTable known = runs();
  known.del_rule = DelRule{};
  const WindDistribution wind = WindDistribution::rayleigh(10.0);
  EXPECT_THAT(life_text(life_table(known, {"TwrBsMyt_del4"}, wind), wind),
              HasSubstr("\nDEL: R the full range, reference one cycle per second"));
  EXPECT_EQ(life_table(known, {"GenPwr_mean"}, wind).del_text, "");
}

// The usual ones are those that all tables have, in one order.
TEST(UsualQuantities, OfAllTables) {
  const RunTable both = runs();
  RunTable other = both;
  other.figures[1] = "TwrBsMyt_del5 [kNm]";
  EXPECT_THAT(usual_quantities({&both}),
              ElementsAre("RotSpeed_max", "GenPwr_mean", "TwrBsMyt_del4"));
  EXPECT_THAT(usual_quantities({&both, &other}), ElementsAre("RotSpeed_max", "GenPwr_mean"));
}

// No run, no such quantity, nothing usual.
TEST(LifeTable, Faults) {
  RunTable none{"fb", {"x_mean [m]"}, {}, 0};
  EXPECT_THAT(test::error_text([&] {
                life_table(none, {"x_mean"}, {10.0, 2.0});
              }),
              HasSubstr("'fb' has no run"));
  EXPECT_THAT(test::error_text([&] { usual_quantities({&none}); }),
              HasSubstr("none of the usual quantities"));
  EXPECT_THAT(test::error_text([&] {
                life_table(runs(), {"GenPwr_men"}, {10.0, 2.0});
              }),
              HasSubstr("has no quantity 'GenPwr_men' (did you mean 'GenPwr_mean'?)"));
}

}  // namespace
}  // namespace lac::sim
