// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/mounting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"
#include "tests/sim_harness/lidar/rough_sea.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

constexpr double kHub_m = 90.0;

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// The attitude that a measurement reports is that of the lidar.
void expect_consistent(const LidarPose& pose) {
  const Rotation again = rotation_from_roll_pitch_yaw(pose.roll_rad, pose.pitch_rad, pose.yaw_rad);
  for (const Vec3& v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    expect_near(again * v, pose.R_IL * v, 1e-12);
  }
}

/// A turbine that swings and turns, smoothly.
TurbineState turbine_at(double t) {
  TurbineState s;
  s.tower_x_m = 0.5 * std::sin(2.0 * t);
  s.tower_v_mps = std::cos(2.0 * t);
  s.rotor_speed_radps = 1.2;
  s.azimuth_rad = 1.2 * t;
  return s;
}

// Tower, platform, bending and spinner at once: the velocity is the slope of the position over
// time (central difference of 2 ms), and the reported angles are the attitude.
TEST(MountingTest, VelocityIsTheSlopeOfThePosition) {
  for (const MountingPlace place : {MountingPlace::kNacelle, MountingPlace::kSpinner}) {
    MountingParams p;
    p.place = place;
    p.offset_m = {-4.0, 0.6, 2.5};
    p.tilt_rad = 0.1;
    p.roll_rad = 0.2;
    p.yaw_rad = -0.3;
    p.tower_slope = 1.5;
    PlatformMotion sea = rough_sea(0.08);
    sea.reference_height_m = -15.0;
    const Mounting mounting(p, sea, kHub_m);
    for (double t = 0.3; t < 30.0; t += 0.7) {
      const double h = 1e-3;
      const Vec3 slope = (0.5 / h) * (mounting.pose(turbine_at(t + h), t + h).position_I_m -
                                      mounting.pose(turbine_at(t - h), t - h).position_I_m);
      const LidarPose pose = mounting.pose(turbine_at(t), t);
      expect_near(pose.velocity_I_mps, slope, 2e-5);
      expect_consistent(pose);
    }
  }
}

// A lidar that stands still says so: hub height plus offset, roll, tilt, half a turn and its yaw.
TEST(MountingTest, AtRest) {
  MountingParams p;
  p.offset_m = {2.0, -0.5, 3.0};
  p.tilt_rad = 0.1;
  p.roll_rad = -0.2;
  p.yaw_rad = 0.3;
  const LidarPose pose = Mounting(p, {}, kHub_m).pose({}, 12.0);
  EXPECT_EQ(pose.position_I_m, (Vec3{2.0, -0.5, 93.0}));
  EXPECT_EQ(pose.velocity_I_mps, (Vec3{}));
  EXPECT_EQ(pose.pitch_rad, 0.1);
  EXPECT_EQ(pose.roll_rad, -0.2);
  EXPECT_EQ(pose.yaw_rad, kPi + 0.3);
  expect_consistent(pose);
}

// Signs of the mounting angles, looking up-wind along -x: tilt looks down, yaw to the left of the
// viewing axis, which is -y, and roll turns the left side of the lidar (-y at rest) upwards.
TEST(MountingTest, SignsOfTheAngles) {
  MountingParams p;
  p.tilt_rad = 0.1;
  expect_near(Mounting(p, {}, kHub_m).pose({}, 0.0).R_IL * Vec3{1, 0, 0},
              {-std::cos(0.1), 0.0, -std::sin(0.1)}, 1e-12);
  p = {};
  p.yaw_rad = 0.1;
  expect_near(Mounting(p, {}, kHub_m).pose({}, 0.0).R_IL * Vec3{1, 0, 0},
              {-std::cos(0.1), -std::sin(0.1), 0.0}, 1e-12);
  p = {};
  p.roll_rad = 0.1;
  expect_near(Mounting(p, {}, kHub_m).pose({}, 0.0).R_IL * Vec3{0, 1, 0},
              {0.0, -std::cos(0.1), std::sin(0.1)}, 1e-12);
}

// On the spinner at azimuth 90 deg, clockwise looking down-wind: what was up is to the right (-y);
// the velocity is omega r, towards the ground on that side.
TEST(MountingTest, SpinnerTurnsWithTheRotor) {
  MountingParams p;
  p.place = MountingPlace::kSpinner;
  p.offset_m = {-3.0, 0.0, 0.8};
  TurbineState turbine;
  turbine.azimuth_rad = kPi / 2.0;
  turbine.rotor_speed_radps = 1.2;
  const LidarPose pose = Mounting(p, {}, kHub_m).pose(turbine, 0.0);
  expect_near(pose.position_I_m, {-3.0, -0.8, 90.0}, 1e-12);
  expect_near(pose.velocity_I_mps, {0.0, 0.0, -0.96}, 1e-12);
  expect_near(pose.R_IL * Vec3{0, 0, 1}, {0.0, -1.0, 0.0}, 1e-12);
  expect_near(pose.R_IL * Vec3{1, 0, 0}, {-1.0, 0.0, 0.0}, 1e-12);
  expect_consistent(pose);
}

// Bending: a tower top 0.6 m down-wind of a uniform cantilever of 90 m turns by 1.5 x 0.6/90 rad,
// nose down seen from behind: a lidar that looks up-wind looks up.
TEST(MountingTest, TowerTopTurns) {
  MountingParams p;
  p.tower_slope = 1.5;
  p.offset_m = {0.0, 0.0, 2.0};
  TurbineState turbine;
  turbine.tower_x_m = 0.6;
  turbine.tower_v_mps = 0.9;
  const LidarPose pose = Mounting(p, {}, kHub_m).pose(turbine, 0.0);
  expect_near(pose.R_IL * Vec3{1, 0, 0}, {-std::cos(0.01), 0.0, std::sin(0.01)}, 1e-12);
  expect_near(pose.position_I_m, {0.6 + 2.0 * std::sin(0.01), 0.0, 90.0 + 2.0 * std::cos(0.01)},
              1e-12);
  EXPECT_NEAR(pose.velocity_I_mps.x, 0.9 + 0.015 * 2.0 * std::cos(0.01), 1e-12);
}

// A platform that stands still is no platform: the general chain and the short way agree, the
// angles to rounding.
TEST(MountingTest, ShortWay) {
  MountingParams p;
  p.offset_m = {2.0, -0.5, 3.0};
  p.tilt_rad = 0.1;
  PlatformMotion afloat;
  afloat.freedoms[kSurge].harmonics = {{0.0, 10.0, 0.0}};
  const LidarPose a = Mounting(p, {}, kHub_m).pose(turbine_at(1.0), 1.0);
  const LidarPose b = Mounting(p, afloat, kHub_m).pose(turbine_at(1.0), 1.0);
  expect_near(a.position_I_m, b.position_I_m, 1e-12);
  expect_near(a.velocity_I_mps, b.velocity_I_mps, 1e-12);
  EXPECT_NEAR(a.roll_rad, b.roll_rad, 1e-12);
  EXPECT_NEAR(a.pitch_rad, b.pitch_rad, 1e-12);
  EXPECT_NEAR(a.yaw_rad, b.yaw_rad, 1e-12);
}

// Keys and their faults.
TEST(MountingTest, Reader) {
  const test::TempFolder folder;
  const auto read = [&](const std::string& text) {
    YamlReader in = YamlReader::load(folder.write("lidar.yaml", text));
    const MountingParams p = read_mounting(in);
    in.finish();
    return p;
  };
  const MountingParams p = read(
      "mounted_on: spinner\noffset_m: [1, 2, 3]\ntilt_deg: 5\nroll_deg: 90\nyaw_deg: -5\n"
      "tower_slope: 2\n");
  EXPECT_EQ(p.place, MountingPlace::kSpinner);
  EXPECT_EQ(p.offset_m, (Vec3{1, 2, 3}));
  EXPECT_DOUBLE_EQ(p.roll_rad, kPi / 2.0);
  EXPECT_DOUBLE_EQ(p.yaw_rad, rad_from_deg(-5.0));
  EXPECT_EQ(p.tower_slope, 2.0);
  const auto error_of = [&](const std::string& text) {
    return test::error_text([&] { read(text); });
  };
  EXPECT_THAT(error_of("mounted_on: hub\n"), HasSubstr("expected nacelle or spinner"));
  EXPECT_THAT(error_of("offset_m: [1, 2]\n"), HasSubstr("expected three numbers"));
  EXPECT_THAT(error_of("tower_slope: -1\n"), HasSubstr("lidar.yaml:1: tower_slope: found -1"));
  EXPECT_THAT(error_of("tilt_deg: 50\n"), HasSubstr("lidar.yaml:1: tilt_deg: found 50"));
}

}  // namespace
}  // namespace lac::sim
