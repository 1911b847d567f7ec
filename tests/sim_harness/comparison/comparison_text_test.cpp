// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/comparison_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim_harness/tables/csv_table.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

/// A load that falls at 12 m/s and perhaps at 14 m/s.
Comparison example() {
  RunTable a{"fb", {"TwrBsMyt_del4 [kNm]"}, {}, 3}, b{"lac", {"TwrBsMyt_del4 [kNm]"}, {}, 3};
  const double loads[][4] = {{12, 100, 90, 1},  {12, 110, 99.5, 2}, {12, 105, 94, 3},
                             {14, 120, 119, 1}, {14, 130, 134, 2},  {14, 140, 130, 3}};
  for (const auto& l : loads) {
    const std::string key = std::to_string(l[0]) + std::to_string(l[3]);
    a.runs.push_back({key, l[0], {l[1]}, ""});
    b.runs.push_back({key, l[0], {l[2]}, ""});
  }
  b.runs.push_back({"alone", 16, {1}, ""});
  return compare_runs(a, b, {});
}

// The table, the words, the convention and the warning about chance.
TEST(ComparisonText, TableAndWords) {
  const std::string text = comparison_text(example(), WindDistribution::rayleigh(10.0));
  EXPECT_THAT(text, HasSubstr("change from A = fb to B = lac"));
  EXPECT_THAT(text, HasSubstr("12            3  -10.0 ± 1.2 %"));
  EXPECT_THAT(text, HasSubstr("(-1.8 ± 13.6 %)"));
  EXPECT_THAT(text, HasSubstr("TwrBsMyt_del4 [kNm]: significant at 12 m/s; not significant at 95 % "
                              "at 14 m/s; life "));
  EXPECT_THAT(text, HasSubstr("scale 11.28 m/s, shape 2; the bins cover"));
  EXPECT_THAT(text, HasSubstr("of 2 comparisons about 0.1 would be called significant by chance"));
  EXPECT_THAT(text, HasSubstr("0 runs of A, 1 of B; not done and left out: 3 rows"));
}

// What the loads are is said; that it is not known, too; without loads nothing.
TEST(ComparisonText, ConventionOfLoads) {
  const WindDistribution wind = WindDistribution::rayleigh(10.0);
  Comparison c = example();
  EXPECT_THAT(comparison_text(c, wind), HasSubstr("\nDEL: convention not known"));
  c.del_text = DelRule{}.text();
  EXPECT_THAT(comparison_text(c, wind),
              HasSubstr("\nDEL: R the full range, reference one cycle per second"));
  c.del_text.clear();
  EXPECT_THAT(comparison_text(c, wind), ::testing::Not(HasSubstr("DEL:")));
}

// The written table has the same numbers, and the life as a row of its own.
TEST(ComparisonCsv, RowsPerSpeedAndLife) {
  const test::TempFolder folder;
  const Comparison c = example();
  const CsvTable t(folder.write("c.csv", comparison_csv(c)));
  ASSERT_EQ(t.rows(), 3U);
  EXPECT_EQ(t.number(0, t.column("relative_change")), c.quantities[0].at_speed[0]->relative);
  EXPECT_EQ(t.text(1, t.column("verdict")), "not significant at 95 %");
  EXPECT_EQ(t.text(2, t.column("wind_speed_mps")), "life");
  EXPECT_EQ(t.number(2, t.column("b")), c.quantities[0].life->b);
}

}  // namespace
}  // namespace lac::sim
