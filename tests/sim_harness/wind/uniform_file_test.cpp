// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/uniform_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "sim_harness/wind/iec_wind.hpp"
#include "sim_harness/wind/uniform_wind.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

class UniformFile : public testing::Test {
 protected:
  UniformTable read(const std::string& text) {
    return read_uniform_file(folder_.write("x.hh", text));
  }
  std::string error(const std::string& text) {
    return test::error_text([&] { read(text); });
  }

  test::TempFolder folder_;
};

// Nine columns in the order of the format, angles in degrees; comments, tabs, commas, line ends of
// other systems.
TEST_F(UniformFile, ReadsByTheDescription) {
  const UniformTable table = read(
      "! a comment\n# another\n\n  0.0 12 10 0.5 0.1 0.2 0.3 1.5 8 ! the start\r\n"
      "1.5,\t13,20,0.6,0.1,0.2,0.3,+2.5,9\n");
  ASSERT_EQ(table.rows.size(), 2u);
  const UniformRow& row = table.rows[0];
  EXPECT_EQ(row.time_s, 0.0);
  EXPECT_EQ(row.state.speed_mps, 12.0);
  EXPECT_DOUBLE_EQ(row.state.direction_rad, rad_from_deg(10.0));
  EXPECT_EQ(row.state.vertical_mps, 0.5);
  EXPECT_EQ(row.state.shear_y, 0.1);
  EXPECT_EQ(row.state.shear_exponent, 0.2);
  EXPECT_EQ(row.state.shear_z, 0.3);
  EXPECT_EQ(row.state.gust_mps, 1.5);
  EXPECT_DOUBLE_EQ(row.state.upflow_rad, rad_from_deg(8.0));
  EXPECT_EQ(table.rows[1].time_s, 1.5);
  EXPECT_EQ(table.rows[1].state.gust_mps, 2.5);
}

// The ninth column may be missing; a direction of 350 deg after 10 deg is -10 deg.
TEST_F(UniformFile, EightColumnsAndTheShorterWayRound) {
  const UniformTable table = read("0 12 10 0 0 0 0 0\n1 12 350 0 0 0 0 0\n2 12 170 0 0 0 0 0\n");
  EXPECT_EQ(table.rows[0].state.upflow_rad, 0.0);
  EXPECT_NEAR(deg_from_rad(table.rows[1].state.direction_rad), -10.0, 1e-12);
  EXPECT_NEAR(std::abs(deg_from_rad(table.rows[2].state.direction_rad) + 10.0), 180.0, 1e-12);
}

// An operating gust, tabulated every 0.05 s, written and read: the wind of the table is the gust
// within the error of straight lines, dt^2 / 8 of the greatest curvature (below 2 mm/s), and idle
// stretches take two rows.
TEST_F(UniformFile, RoundTripOfAGust) {
  UniformWindParams gust;
  gust.history = GustSpeed{18.0, 7.76, 60.0};
  gust.shear_exponent = 0.2;
  const UniformWind wind(gust);
  const UniformTable table = tabulate(wind, 0.0, 600.0, 0.05);
  EXPECT_LT(table.rows.size(), 220u);
  write_uniform_file(folder_.file("gust.hh"), table, "a gust");
  UniformWindParams read_back;
  read_back.history = read_uniform_file(folder_.file("gust.hh"));
  const UniformWind back(read_back);
  for (int i = -100; i < 7000; ++i) {
    const double t = 0.1 * i + 0.013;
    for (const double z : {30.0, 90.0, 150.0}) {
      EXPECT_NEAR(back.velocity({0.0, 20.0, z}, t).x, wind.velocity({0.0, 20.0, z}, t).x, 2e-3)
          << t;
    }
  }
}

// Faults, each with its place.
TEST_F(UniformFile, Faults) {
  EXPECT_THAT(error("0 12 0 0 0 0 0\n"), HasSubstr("x.hh:1: found 7 numbers, expected 8 or 9"));
  EXPECT_THAT(error("! c\n0 12 0 0 0 0 0 0\n1 12 0 0 0 0 0 0 0\n"),
              HasSubstr("x.hh:3: found 9 numbers, expected 8 as in the first row"));
  EXPECT_THAT(error("0 12 0 0 0 0 0 x0\n"), HasSubstr("x.hh:1: found 'x0', expected a number"));
  EXPECT_THAT(error("0 12 0 0 0 0 0 nan\n"), HasSubstr("found 'nan', expected a number"));
  EXPECT_THAT(error("1 12 0 0 0 0 0 0\n1 12 0 0 0 0 0 0\n"),
              HasSubstr("x.hh:2: found time 1.000000 s, expected one after 1.000000 s"));
  EXPECT_THAT(error("! nothing\n"), HasSubstr("found no row of numbers"));
  EXPECT_THAT(error(std::string("\x9d\xff\x04\0\x03\0\0\0", 8)), HasSubstr("no text"));
  EXPECT_THAT(test::error_text([&] { read_uniform_file(folder_.file("gone.hh")); }),
              HasSubstr("gone.hh: cannot be opened"));
  EXPECT_THROW(write_uniform_file(folder_.file("no/x.hh"), {}, ""), Error);
}

}  // namespace
}  // namespace lac::sim
