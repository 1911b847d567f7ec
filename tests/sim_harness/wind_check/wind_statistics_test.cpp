// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/wind_statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "sim_harness/wind/uniform_wind.hpp"

namespace lac::sim {
namespace {

/// 10 m/s +- 2 m/s, a sine of 20 s, power law 0.2, turned by 8 deg with 4 deg of upflow.
UniformWind turning_sine() {
  UniformTable table;
  for (int i = 0; i <= 400; ++i) {
    table.rows.push_back({0.5 * i,
                          {.speed_mps = 10.0 + 2.0 * std::sin(kPi * i / 20.0),
                           .direction_rad = rad_from_deg(8.0),
                           .shear_exponent = 0.2,
                           .upflow_rad = rad_from_deg(4.0)}});
  }
  UniformWindParams params;
  params.history = table;
  return UniformWind(params);
}

RotorWindParams rotor() {
  RotorWindParams r;
  r.t_end_s = 99.5;
  r.dt_s = 0.5;
  return r;
}

// Hub: mean and extremes of the components by hand (cos 8 cos 4, -sin 8 cos 4, sin 4), intensity
// of a sine A / sqrt 2 / U with n - 1; direction, upflow and exponent as put in.
TEST(WindStatistics, ByHand) {
  const WindStatistics s = wind_statistics(turning_sine(), rotor(), 40.0);
  EXPECT_NEAR(s.hub[0].mean, 9.878562, 1e-5);
  EXPECT_NEAR(s.hub[0].max, 12.0 * 0.9878562, 1e-5);
  EXPECT_NEAR(s.hub[1].mean, -1.388341, 1e-5);
  EXPECT_NEAR(s.hub[2].mean, 0.697565, 1e-5);
  EXPECT_NEAR(s.hub_intensity[0], 0.2 / std::sqrt(2.0) * std::sqrt(200.0 / 199.0), 1e-9);
  EXPECT_NEAR(s.hub_intensity[2], s.hub_intensity[0] * 0.0697565 / 0.9878562, 1e-8);
  EXPECT_NEAR(deg_from_rad(s.direction_rad), 8.0, 1e-9);
  EXPECT_NEAR(deg_from_rad(s.upflow_rad), 4.0, 1e-9);
  EXPECT_NEAR(s.shear_exponent, 0.2, 1e-9);
  EXPECT_NEAR(s.intensity.mean, 0.2 / std::sqrt(2.0) * std::sqrt(80.0 / 79.0), 1e-6);
  EXPECT_NEAR(s.shear_y.mean, 0.0, 1e-12);
  EXPECT_NEAR(s.shear_z.mean / s.rews.mean, 0.2 / 90.0 * 1.0, 0.2 / 90.0 * 0.09);
}

// A window longer than the wind is the wind: one value.
TEST(WindStatistics, LongWindow) {
  const WindStatistics s = wind_statistics(turning_sine(), rotor(), 600.0);
  EXPECT_EQ(s.window_s, 100.0);
  EXPECT_EQ(s.intensity.standard_deviation, 0.0);
  EXPECT_EQ(s.intensity.min, s.intensity.max);
}

// The table names what it shows; the channels are the series behind it.
TEST(WindStatistics, TableAndChannels) {
  const UniformWind wind = turning_sine();
  const WindStatistics s = wind_statistics(wind, rotor(), 40.0);
  const std::string table = statistics_table(s);
  EXPECT_THAT(table, ::testing::ContainsRegex("hub u +m/s +9.879 +1.4.. +14.18 % +7.90"));
  EXPECT_THAT(table, ::testing::HasSubstr("windows of 40.0 s; 497 points within 63.0 m"));
  EXPECT_THAT(table, ::testing::HasSubstr("exponent 0.200; direction 8.00 deg, upflow 4.00 deg"));
  const Recording channels = wind_channels(wind, s.signals, 90.0);
  ASSERT_EQ(channels.rows(), 200u);
  EXPECT_NEAR(channels.column("RtVAvgxh")[7], s.signals.rews_mps[7], 1e-5);
  EXPECT_NEAR(channels.column("RtShrVer")[7], s.signals.shear_z_per_s[7], 1e-8);
  EXPECT_NEAR(channels.column("WindHubVelZ")[10], 12.0 * 0.0697565, 1e-5);
  EXPECT_TRUE(std::isnan(channels.column("RtTI")[78]));
  EXPECT_NEAR(channels.column("RtTI")[79], s.signals.intensity[79], 1e-7);
}

}  // namespace
}  // namespace lac::sim
