// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/scan_pattern.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/lidar_block.hpp"
#include "core/units.hpp"
#include "sim_harness/lidar/scan_clock.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

class ScanPatternTest : public ::testing::Test {
 protected:
  ScanPattern read(const std::string& text) {
    YamlReader in = YamlReader::load(folder_.write("scan.yaml", text));
    ScanPattern scan = read_scan_pattern(in);
    in.finish();
    return scan;
  }
  std::string error_of(const std::string& text) {
    return test::error_text([&] { read(text); });
  }

  test::TempFolder folder_;
};

/// Ends of the first slots [s].
std::vector<double> ends_of(const ScanPattern& scan, int count) {
  ScanClock clock(scan);
  std::vector<double> ends_s;
  for (int i = 0; i < count; ++i, clock.next()) ends_s.push_back(clock.end_s());
  return ends_s;
}

constexpr char kCircle[] =
    "scan: circle\ncone_half_angle_deg: 15\npoints_per_turn: 8\nturn_time_s: 2\n";

// Eight points on a cone: all 15 deg from the axis, the first at the top, then to the right (-y)
// as a clock seen along the axis, 45 deg apart; a quarter of a second each.
TEST_F(ScanPatternTest, Circle) {
  const ScanPattern scan = read(kCircle);
  ASSERT_EQ(scan.beams.size(), 8U);
  EXPECT_DOUBLE_EQ(scan.beam_time_s, 0.25);
  EXPECT_DOUBLE_EQ(scan.scan_time_s(), 2.0);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3 n = beam_direction(scan.beams[i].azimuth_rad, scan.beams[i].elevation_rad);
    const double turned = rad_from_deg(45.0 * static_cast<double>(i));
    const double s = std::sin(rad_from_deg(15.0));
    EXPECT_NEAR(n.x, std::cos(rad_from_deg(15.0)), 1e-12);
    EXPECT_NEAR(n.y, -s * std::sin(turned), 1e-12);
    EXPECT_NEAR(n.z, s * std::cos(turned), 1e-12);
  }
}

// The other way round, beginning a quarter of a turn on: to the left first.
TEST_F(ScanPatternTest, CircleTheOtherWayRound) {
  const ScanPattern scan =
      read(std::string(kCircle) + "direction: counter_clockwise\nstart_deg: 90\n");
  EXPECT_NEAR(scan.beams[0].azimuth_rad, rad_from_deg(15.0), 1e-12);
  EXPECT_NEAR(scan.beams[0].elevation_rad, 0.0, 1e-12);
  EXPECT_NEAR(scan.beams[2].elevation_rad, rad_from_deg(-15.0), 1e-12);
}

// A table in the file itself: own times, own gates, the rest by default.
TEST_F(ScanPatternTest, TableInTheFile) {
  const ScanPattern scan = read(
      "scan: table\n"
      "beams:\n"
      "  - {azimuth_deg: 10, elevation_deg: 0, time_s: 0.5}\n"
      "  - {azimuth_deg: -10, elevation_deg: 5, gates_m: [80, 120]}\n"
      "beam_time_s: 0.2\n"
      "beam_pause_s: 0.1\n"
      "scan_pause_s: 0.3\n");
  ASSERT_EQ(scan.beams.size(), 2U);
  EXPECT_DOUBLE_EQ(scan.beams[1].elevation_rad, rad_from_deg(5.0));
  EXPECT_EQ(scan.beams[1].gates_m, (std::vector<double>{80.0, 120.0}));
  EXPECT_DOUBLE_EQ(scan.scan_time_s(), 0.5 + 0.1 + 0.2 + 0.3);
  const std::vector<double> ends_s = ends_of(scan, 4);
  EXPECT_NEAR(ends_s[0], 0.5, 1e-12);
  EXPECT_NEAR(ends_s[1], 0.8, 1e-12);
  EXPECT_NEAR(ends_s[2], 1.6, 1e-12);
  EXPECT_NEAR(ends_s[3], 1.9, 1e-12);
}

// The same in a file of its own, with times and foci, comments and Windows line ends.
TEST_F(ScanPatternTest, TableInAFileOfItsOwn) {
  folder_.write("beams.txt", "# az el time focus\r\n10 0 0.5 80\r\n\r\n-10, 5, 0.25, 120\r\n");
  const ScanPattern scan = read("scan: table\nbeam_file: beams.txt\n");
  ASSERT_EQ(scan.beams.size(), 2U);
  EXPECT_DOUBLE_EQ(scan.beams[0].time_s, 0.5);
  EXPECT_EQ(scan.beams[1].gates_m, (std::vector<double>{120.0}));
  EXPECT_DOUBLE_EQ(scan.scan_time_s(), 0.75);
}

// Beams taken at once: all end together, once per scan.
TEST_F(ScanPatternTest, AtOnce) {
  const ScanPattern scan = read(
      "beam_azimuth_deg: [10, 0, -10]\nbeam_elevation_deg: [0, 0, 0]\nbeam_time_s: 0.5\n"
      "beams_taken: at_once\nscan_pause_s: 0.25\n");
  EXPECT_DOUBLE_EQ(scan.scan_time_s(), 0.75);
  EXPECT_EQ(ends_of(scan, 3), (std::vector<double>{0.5, 1.25, 2.0}));
  EXPECT_EQ(ScanClock(scan).slot().beam_count, 3U);
}

// Samples lie in the middle of equal parts of the beam time; a single one at its end.
TEST_F(ScanPatternTest, SampleTimes) {
  ScanPattern scan = read(
      "beam_azimuth_deg: [0, 0]\nbeam_elevation_deg: [0, 0]\nbeam_time_s: 1\n"
      "samples_per_beam: 4\n");
  ScanClock clock(scan);
  clock.next();
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(clock.sample_time_s(i), 1.125 + 0.25 * i, 1e-12);
  scan.samples_per_beam = 1;
  EXPECT_EQ(ScanClock(scan).sample_time_s(0), 1.0);
}

// Each fault names file, line and key.
TEST_F(ScanPatternTest, Faults) {
  EXPECT_THAT(error_of("scan: circel\n"), HasSubstr("(did you mean 'circle'?)"));
  EXPECT_THAT(error_of("scan: circle\ncone_half_angle_deg: 0\n"),
              HasSubstr("scan.yaml:2: cone_half_angle_deg: found 0"));
  EXPECT_THAT(error_of("scan: circle\ncone_half_angle_deg: 15\npoints_per_turn: 1\n"),
              HasSubstr("scan.yaml:3: points_per_turn: found 1"));
  EXPECT_THAT(error_of(std::string(kCircle) + "beam_azimuth_deg: [1]\n"),
              HasSubstr("beam_azimuth_deg: unknown key"));
  EXPECT_THAT(error_of("scan: table\nbeam_time_s: 1\n"),
              HasSubstr("beams: expected either a list of beams or beam_file"));
  EXPECT_THAT(error_of("scan: table\nbeams:\n  - {azimuth_deg: 10, elevation_deg: 85}\n"),
              HasSubstr("scan.yaml:3: beams.0.elevation_deg: found 85"));
  EXPECT_THAT(error_of("scan: table\nbeams:\n  - {azimuth_deg: 10, elevation_deg: 8}\n"),
              HasSubstr("beam_time_s: the key is missing"));
  const std::string fixed =
      "beam_azimuth_deg: [0, 0]\nbeam_elevation_deg: [0, 0]\nbeam_time_s: 1\n";
  EXPECT_THAT(error_of(fixed + "beam_pause_s: -1\n"), HasSubstr("beam_pause_s: found -1"));
  EXPECT_THAT(error_of(fixed + "samples_per_beam: 0\n"), HasSubstr("samples_per_beam: found 0"));
  EXPECT_THAT(error_of(fixed + "beams_taken: at_once\nbeam_pause_s: 1\n"),
              HasSubstr("there is no pause between beams that are taken at once"));
  EXPECT_THAT(error_of("scan: table\nbeams_taken: at_once\nbeam_time_s: 1\n"
                       "beams: [{azimuth_deg: 0, elevation_deg: 0, time_s: 1}]\n"),
              HasSubstr("share beam_time_s"));
}

// Faults of a beam file.
TEST_F(ScanPatternTest, FaultsOfABeamFile) {
  const auto error_with = [&](const std::string& table) {
    folder_.write("beams.txt", table);
    return error_of("scan: table\nbeam_file: beams.txt\n");
  };
  EXPECT_THAT(error_with("# nothing\n"), HasSubstr("beams.txt: found no line with numbers"));
  EXPECT_THAT(error_with("10 0 1\n10\n"),
              HasSubstr("beams.txt:2: found 1 numbers, expected azimuth_deg elevation_deg [time_s "
                        "[focus_m]], as many in each line"));
  EXPECT_THAT(error_with("10 zero 1\n"), HasSubstr("beams.txt:1: found 'zero', expected a number"));
  EXPECT_THAT(error_with("10 0 nan\n"), HasSubstr("beams.txt:1: found 'nan', expected a number"));
  EXPECT_THAT(error_with("10 0 0.5\n90 0 0.5\n"),
              HasSubstr("beams.txt:2: azimuth_deg: found 90, expected"));
  EXPECT_THAT(error_with("10 0 0.5 -3\n"), HasSubstr("beams.txt:1: focus_m: found -3"));
  EXPECT_THAT(error_with("\xEF\xBB\xBF+10,0 5D-1 -3\r\n"),
              HasSubstr("beams.txt:1: focus_m: found -3"));
  EXPECT_THAT(error_with(std::string("10 0\0 1\n", 8)), HasSubstr("bytes that are no text"));
}

}  // namespace
}  // namespace lac::sim
