// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

/// 10 s of rubbish, then 100 s of sines at 0.1 Hz around known means.
Recording sines(double amplitude) {
  Recording r(
      {{"RotSpeed", "rpm"}, {"BldPitchRate", "deg/s"}, {"GenPwr", "kW"}, {"TwrBsMyt", "kNm"}}, 0.0,
      0.1, 1100);
  for (int i = 0; i < 1100; ++i) {
    const double s = amplitude * std::sin(2.0 * kPi * 0.1 * (0.1 * i + 2.5));
    const double off = i < 100 ? 1e4 : 0.0;
    const float row[] = {static_cast<float>(12.0 + s + off), static_cast<float>(s + off),
                         static_cast<float>(5000.0 + 10.0 * s + off),
                         static_cast<float>(4e4 + 1000.0 * s + off)};
    r.append(row);
  }
  return r;
}

// Figures of a sine: standard deviation a / sqrt 2 (with n - 1), and ten full ranges 2 a in 100 s
// (the first starts at a crest; the residue counts half twice less): (10 (2 a)^4 / 100)^(1/4).
TEST(ResultsTest, FiguresOfASine) {
  const FlightFigures f = flight_figures(sines(0.5), 10.0);
  const double deviation = 0.5 / std::sqrt(2.0) * std::sqrt(1000.0 / 999.0);
  EXPECT_NEAR(f.rotor_speed_std_rpm, deviation, 1e-5);
  EXPECT_NEAR(f.pitch_rate_std_degps, deviation, 1e-5);
  EXPECT_NEAR(f.power_std_kW, 10.0 * deviation, 1e-3);
  EXPECT_NEAR(f.rotor_speed_max_rpm, 12.5, 1e-5);
  EXPECT_NEAR(f.power_mean_kW, 5000.0, 1e-3);
  EXPECT_NEAR(f.tower_base_del_MNm, std::pow(10.0 / 100.0, 0.25), 0.01);
}

// Changes count from the first flight; the table spells the convention of the load out.
TEST(ResultsTest, Table) {
  const std::vector<FlightFigures> flights{flight_figures(sines(0.5), 10.0),
                                           flight_figures(sines(0.4), 10.0)};
  const auto rows = result_rows(flights);
  EXPECT_NEAR(rows[0].relative_change, -0.2, 1e-5);
  const std::string table = result_table({"feedback", "lidar"}, rows);
  EXPECT_THAT(table, HasSubstr("-20.0 %"));
  EXPECT_THAT(table, HasSubstr("feedback"));
  EXPECT_THAT(table, HasSubstr("m = 4"));
  EXPECT_THAT(table, HasSubstr("ASTM E1049"));
}

}  // namespace
}  // namespace lac::sim
