// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

constexpr char kLidar[] =
    "beam_azimuth_deg: [15, -15]\n"
    "beam_elevation_deg: [0, 0]\n"
    "gates_m: [50, 80]\n"
    "gates_along: beam\n"
    "beam_time_s: 0.5\n"
    "fwhm_m: 30\n";

std::string error_of(const std::string& text) {
  const test::TempFolder folder;
  return test::error_text([&] { load_lidar(folder.write("lidar.yaml", text)); });
}

// The shipped lidar is the one of the paper: four beams in a second, ten gates.
TEST(LidarParamsTest, ShippedFourBeamLidar) {
  const LidarParams p = load_lidar(LAC_SOURCE_DIR "/config/lidars/four_beam_pulsed.yaml");
  ASSERT_EQ(p.scan.beams.size(), 4U);
  EXPECT_DOUBLE_EQ(p.scan.beams[2].azimuth_rad, rad_from_deg(-14.4));
  EXPECT_DOUBLE_EQ(p.scan.beams[3].elevation_rad, rad_from_deg(14.0));
  EXPECT_EQ(p.gates_m.size(), 10U);
  EXPECT_FALSE(p.gates_along_beam);
  EXPECT_DOUBLE_EQ(p.scan.scan_time_s(), 1.0);
  EXPECT_EQ(describe(p), "4 beams, 10 gates from 50 to 170 m, scan 1 s");
}

TEST(LidarParamsTest, ShippedPointPreview) {
  const LidarParams p = load_lidar(LAC_SOURCE_DIR "/config/lidars/point_preview.yaml");
  EXPECT_EQ(p.weighting.fwhm_m, 0.0);
}

// Optional keys and what they default to.
TEST(LidarParamsTest, Defaults) {
  const test::TempFolder folder;
  const LidarParams p = load_lidar(folder.write("lidar.yaml", kLidar));
  EXPECT_TRUE(p.gates_along_beam);
  EXPECT_EQ(p.weighting.points, 9);
  EXPECT_EQ(p.mounting.tilt_rad, 0.0);
  EXPECT_EQ(p.mounting.offset_m, (Vec3{}));
}

// Beams that all have gates of their own need no others; a line for reports says what there is.
TEST(LidarParamsTest, GatesOfTheBeams) {
  const test::TempFolder folder;
  const LidarParams p =
      load_lidar(folder.write("lidar.yaml",
                              "scan: table\n"
                              "beams:\n"
                              "  - {azimuth_deg: 10, elevation_deg: 0, gates_m: [60, 90]}\n"
                              "  - {azimuth_deg: -10, elevation_deg: 0, gates_m: [50, 80, 110]}\n"
                              "beam_time_s: 0.5\nbeams_taken: at_once\n"
                              "gates_along: axis\nprobe: point\nmounted_on: spinner\n"));
  EXPECT_TRUE(p.gates_m.empty());
  EXPECT_EQ(describe(p),
            "2 beams at once, 3 gates from 50 to 110 m, points, scan 0.5 s, on the "
            "spinner");
}

// Gates for beams that all have their own.
TEST(LidarParamsTest, GatesOfNobody) {
  EXPECT_THAT(error_of("scan: table\n"
                       "beams: [{azimuth_deg: 1, elevation_deg: 0, gates_m: [60]}]\n"
                       "beam_time_s: 0.5\ngates_m: [50]\n"),
              HasSubstr("lidar.yaml:4: gates_m: every beam has gates of its own"));
}

// Lists that do not fit together, gates that do not rise, and a mistyped key.
TEST(LidarParamsTest, Faults) {
  const std::string text = kLidar;
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    return error_of(changed.replace(changed.find(from), from.size(), to));
  };
  EXPECT_THAT(with("elevation_deg: [0, 0]", "elevation_deg: [0]"),
              HasSubstr("lidar.yaml:2: beam_elevation_deg: found 1 values, expected 2"));
  EXPECT_THAT(with("[50, 80]", "[80, 50]"), HasSubstr("lidar.yaml:3: gates_m: expected distances"));
  EXPECT_THAT(with("along: beam", "along: beem"),
              HasSubstr("lidar.yaml:4: gates_along: found 'beem', expected beam or axis (did you "
                        "mean 'beam'?)"));
  EXPECT_THAT(with("fwhm_m", "fwmh_m"),
              HasSubstr("fwhm_m: the key is missing; is 'fwmh_m' meant to be it?"));
  EXPECT_THAT(with("[15, -15]", "[15, 85]"), HasSubstr("lidar.yaml:1: beam_azimuth_deg: found 85"));
  std::string many = "[1";
  for (int g = 2; g <= 51; ++g) many += ", " + std::to_string(g);
  EXPECT_THAT(with("[50, 80]", many + "]"),
              HasSubstr("lidar.yaml:3: gates_m: found 51 gates, expected at most 50, as the lidar "
                        "block of the swap array carries"));
  EXPECT_THAT(with("gates_m: [50, 80]\n", ""), HasSubstr("gates_m: the key is missing"));
  EXPECT_THAT(error_of(text + "weighting_points: 6\n"), HasSubstr("expected an odd number"));
  EXPECT_THAT(error_of(text + "tilt_dgr: 6\n"),
              HasSubstr("lidar.yaml:7: tilt_dgr: unknown key (did you mean 'tilt_deg'?)"));
}

}  // namespace
}  // namespace lac::sim
