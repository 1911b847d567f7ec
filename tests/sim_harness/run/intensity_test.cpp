// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/intensity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lac::sim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// 40 s at 0.1 s.
Recording flight() {
  Recording r({{"RtVAvgxh", "m/s"}}, 0.0, 0.1, 401);
  for (int i = 0; i <= 400; ++i) {
    const auto value = static_cast<float>(i);
    r.append(&value);
  }
  return r;
}

/// TI_R = 0.1 + 0.001 t every second, known from 10 s.
RotorSignals rotor() {
  RotorSignals s;
  s.dt_s = 1.0;
  for (int i = 0; i <= 40; ++i) s.intensity.push_back(i < 10 ? kNaN : 0.1 + 0.001 * i);
  return s;
}

/// Rows every 2 s: the lidar is 0.01 high and low in turn, unknown from 30 s; the other is 0.02
/// low.
Recording chain() {
  Recording r({{"TurbulenceIntensity", "-"}, {"PowerLevel", "-"}, {"TurbulenceUncorrected", "-"}},
              0.0, 2.0, 21);
  for (int i = 0; i <= 20; ++i) {
    const double rotor = 0.1 + 0.001 * 2 * i;
    const double lidar = i >= 15 ? kNaN : rotor + (i % 2 == 0 ? 0.01 : -0.01);
    const float row[] = {static_cast<float>(lidar), 1.0F, static_cast<float>(rotor - 0.02)};
    r.append(row);
  }
  return r;
}

// TI_R is held between its samples, and so are the estimates; where one is unknown there is no
// error. Channels that were there stay in front.
TEST(IntensityTest, Channels) {
  const Recording r = with_rotor_intensity({"a", flight(), chain()}, rotor());
  ASSERT_EQ(r.channels().size(), 4U);
  EXPECT_EQ(r.channels()[2].name, "TurbulenceIntensityErr");
  EXPECT_EQ(r.rows(), 401U);
  EXPECT_EQ(r.column("RtVAvgxh")[123], 123.0);
  const auto ti = r.column("RtTI"), lidar = r.column("TurbulenceIntensityErr");
  EXPECT_TRUE(std::isnan(ti[99]));
  EXPECT_NEAR(ti[100], 0.110, 1e-7);
  EXPECT_NEAR(ti[109], 0.110, 1e-7);
  EXPECT_NEAR(ti[110], 0.111, 1e-7);
  EXPECT_TRUE(std::isnan(lidar[99]));
  EXPECT_NEAR(lidar[129], 0.010 - 0.000, 1e-7);  // the chain's row of 12 s is even: high
  EXPECT_NEAR(lidar[139], 0.010 - 0.001, 1e-7);  // still that row, TI_R has moved on
  EXPECT_NEAR(lidar[140], -0.010, 1e-7);
  EXPECT_TRUE(std::isnan(lidar[300]));
}

// Bias, standard deviation and largest error by hand over 12 <= t < 28: eight rows of 2 s, errors
// +-0.01 less the 0.001 by which TI_R rises in the second half of a row.
TEST(IntensityTest, Errors) {
  const Recording r = with_rotor_intensity({"a", flight(), chain()}, rotor());
  const auto errors = intensity_errors(r, rotor(), 12.0);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].estimate, "TurbulenceIntensity");
  EXPECT_NEAR(errors[0].known, 180.0 / 281.0, 1e-12);
  EXPECT_NEAR(errors[0].largest, 0.011, 1e-7);
  // Nine rows of 20 samples from 12 to 30 s, five of them high.
  const double bias = 0.01 / 9.0 - 0.0005;
  EXPECT_NEAR(errors[0].bias, bias, 1e-7);
  const double square = 0.5 * (5 * (1e-4 + 8.1e-5) + 4 * (1e-4 + 1.21e-4)) / 9.0;
  EXPECT_NEAR(errors[0].standard_deviation, std::sqrt((square - bias * bias) * 180.0 / 179.0),
              1e-7);
  EXPECT_EQ(errors[1].known, 1.0);
  EXPECT_NEAR(errors[1].bias, -0.0205, 1e-5);
  EXPECT_THAT(intensity_table({{"a", r, {}}}, rotor(), 12.0, 10.0),
              ::testing::HasSubstr("TurbulenceUncorrected"));
}

// Against TI_R of 3 s later the errors are 0.003 less.
TEST(IntensityTest, Lead) {
  const FlownController flown{"a", flight(), chain()};
  const auto now = with_rotor_intensity(flown, rotor()).column("TurbulenceIntensityErr");
  const auto later = with_rotor_intensity(flown, rotor(), 3.0).column("TurbulenceIntensityErr");
  EXPECT_NEAR(later[150], now[150] - 0.003, 1e-7);
  EXPECT_NEAR(later[75], 0.106 - 0.01 - 0.110, 1e-7);  // known as soon as TI_R of 10 s
}

// With a lead of 3 s and no run-in everything counts from TI_R of 3 s later: it is there for the
// 310 samples from 7 s to 37.9 s, the estimate for the 230 of them before 30 s, while TI_R goes
// from 0.110 to 0.132.
TEST(IntensityTest, LeadAndShortRunIn) {
  const Recording r = with_rotor_intensity({"a", flight(), chain()}, rotor(), 3.0);
  const auto errors = intensity_errors(r, rotor(), 0.0, 3.0);
  EXPECT_NEAR(errors[0].known, 230.0 / 310.0, 1e-12);
  EXPECT_NEAR(errors[0].rotor_mean, 0.121, 1e-9);
  EXPECT_EQ(errors[1].known, 1.0);
  EXPECT_NEAR(errors[1].rotor_mean, 0.1 + 0.001 * 25.0, 1e-9);  // whole seconds 10 ... 40
}

// Without an output file of the chain there is TI_R alone; an estimate never known has no figures.
TEST(IntensityTest, NothingToCompare) {
  const Recording alone = with_rotor_intensity({"a", flight(), {}}, rotor());
  EXPECT_EQ(alone.channels().size(), 2U);
  EXPECT_TRUE(intensity_errors(alone, rotor(), 12.0).empty());
  const Recording r = with_rotor_intensity({"a", flight(), chain()}, rotor());
  const auto late = intensity_errors(r, rotor(), 31.0);
  EXPECT_EQ(late[0].known, 0.0);
  EXPECT_TRUE(std::isnan(late[0].bias));
}

}  // namespace
}  // namespace lac::sim
