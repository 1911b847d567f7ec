// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/channel_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// From t = 20 s: 10 s of rubbish, then 100 s of sines of period 10 s around known means.
Recording sines() {
  Recording r({{"GenPwr", "kW"}, {"BldPitch1", "deg"}, {"TwrBsMyt", "kNm"}}, 20.0, 0.25, 440);
  for (int i = 0; i < 440; ++i) {
    const double s = std::cos(2.0 * kPi * 0.025 * (i - 40));
    const double off = i < 40 ? 1e4 : 0.0;
    const float row[] = {static_cast<float>(5000.0 + 10.0 * s + off),
                         static_cast<float>(8.0 + s + off), static_cast<float>(2.0 * s + off)};
    r.append(row);
  }
  return r;
}

FigureOptions settled() {
  FigureOptions o;
  o.from_s = 30.0;
  return o;
}

// Closed forms of a sine of amplitude 2: extremes at their first time, nine and three quarters of a
// cycle with the half cycles of the residue: ten crests, DEL 4 (n / 100)^(1/m).
TEST(ChannelFigures, OfASine) {
  const auto figures = channel_figures(sines(), settled(), {"TwrBsMyt"});
  ASSERT_EQ(figures.size(), 1U);
  const ChannelFigures& f = figures[0];
  EXPECT_NEAR(f.statistics.mean, 0.0, 1e-7);
  EXPECT_NEAR(f.statistics.standard_deviation, 2.0 / std::sqrt(2.0) * std::sqrt(400.0 / 399.0),
              1e-6);
  EXPECT_EQ(f.max_time_s, 30.0);
  EXPECT_EQ(f.statistics.max, 2.0);
  EXPECT_EQ(f.min_time_s, 35.0);
  const double last = 2.0 + 2.0 * std::cos(2.0 * kPi * 0.025 * 39.0);  // the last half cycle
  const double damage4 = 9.5 * std::pow(4.0, 4.0) + 0.5 * std::pow(last, 4.0);
  EXPECT_NEAR(f.damage_equivalent[0], std::pow(damage4 / 100.0, 0.25), 1e-6);
  EXPECT_NEAR(f.damage_equivalent[1], 4.0 * std::pow(10.0 / 100.0, 0.1), 0.01);
  EXPECT_FALSE(f.travel);
  EXPECT_FALSE(f.energy_kWh);
}

// A sine travels 4 amplitudes a period (here less the last quarter degree); energy is mean times
// duration.
TEST(ChannelFigures, TravelAndEnergy) {
  const auto figures = channel_figures(sines(), settled());
  EXPECT_NEAR(*figures[0].energy_kWh, 5000.0 * 100.0 / 3600.0, 1e-4);
  const double missing = 1.0 - std::cos(2.0 * kPi * 0.025 * 39.0);
  EXPECT_NEAR(*figures[1].travel, 40.0 - missing, 1e-4);
  EXPECT_EQ(figures_duration_s(sines(), settled()), 100.0);
}

// Which channels have travel and which energy.
TEST(ChannelFigures, KindsOfChannels) {
  EXPECT_TRUE(is_pitch_angle({"BldPitch2", "deg"}));
  EXPECT_TRUE(is_pitch_angle({"PtchPMzc1", "deg"}));
  EXPECT_FALSE(is_pitch_angle({"BldPitchRate", "deg/s"}));
  EXPECT_FALSE(is_pitch_angle({"PtfmPitch", "deg"}));
  EXPECT_EQ(kilowatts_per_unit({"GenPwr", "MW"}), 1e3);
  EXPECT_EQ(kilowatts_per_unit({"GenPwr", "W"}), 1e-3);
  EXPECT_FALSE(kilowatts_per_unit({"GenTq", "kNm"}));
}

// Columns of a table with one row per run.
TEST(ChannelFigures, SideBySide) {
  FigureOptions o = settled();
  o.woehler_exponents = {4.5};
  std::vector<std::string> headers;
  for (const NamedFigure& f : named_figures(channel_figures(sines(), o, {"GenPwr"}), o))
    headers.push_back(f.header());
  EXPECT_THAT(headers, ElementsAre("GenPwr_mean [kW]", "GenPwr_std [kW]", "GenPwr_min [kW]",
                                   "GenPwr_min_time [s]", "GenPwr_max [kW]", "GenPwr_max_time [s]",
                                   "GenPwr_del4.5 [kW]", "GenPwr_energy [kWh]"));
}

// A gap leaves the channel without figures and is counted; the other channels have theirs.
TEST(ChannelFigures, GapsAreCounted) {
  Recording r({{"BldPitch1", "deg"}, {"RotSpeed", "rpm"}}, 0.0, 1.0, 3);
  for (const float pitch : {1.0F, std::nanf(""), 2.0F}) {
    const float row[] = {pitch, 12.0F};
    r.append(row);
  }
  const auto figures = channel_figures(r, {});
  EXPECT_EQ(figures[0].not_finite, 1U);
  EXPECT_TRUE(std::isnan(figures[0].statistics.mean));
  EXPECT_TRUE(std::isnan(figures[0].damage_equivalent[1]));
  EXPECT_TRUE(std::isnan(*figures[0].travel));
  EXPECT_EQ(figures[1].statistics.mean, 12.0);
}

// Faults of the request name what there is.
TEST(ChannelFigures, Faults) {
  EXPECT_THAT(test::error_text([] { channel_figures(sines(), {}, {"TwrBsMyT"}); }),
              HasSubstr("no channel 'TwrBsMyT' (did you mean 'TwrBsMyt'?); there are: GenPwr"));
  FigureOptions late;
  late.from_s = 129.9;
  EXPECT_THAT(test::error_text([&] { channel_figures(sines(), late); }),
              HasSubstr("fewer than two samples from 129.9 s to inf s: the recording goes from "
                        "20 s to 130 s"));
}

}  // namespace
}  // namespace lac::sim
