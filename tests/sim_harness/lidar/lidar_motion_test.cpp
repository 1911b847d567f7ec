// SPDX-License-Identifier: Apache-2.0
// What a lidar sees from something that moves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/units.hpp"
#include "sim_harness/lidar/function_wind.hpp"
#include "sim_harness/lidar/lidar_sim.hpp"
#include "support/error_text.hpp"
#include "tests/sim_harness/lidar/rough_sea.hpp"

namespace lac::sim {
namespace {

using test::FunctionWind;
using ::testing::HasSubstr;

constexpr double kStep_s = 0.0125;
const LidarSetting kSetting{90.0, kStep_s, 60.0};

Vec3 still(const Vec3&, double) {
  return {};
}
Vec3 oblique(const Vec3&, double) {
  return {12.0, 3.0, -1.5};
}

LidarParams four_beams() {
  LidarParams p;
  const double a = rad_from_deg(15.0);
  p.scan.beams = {{a, a, 0.0, {}}, {a, -a, 0.0, {}}, {-a, -a, 0.0, {}}, {-a, a, 0.0, {}}};
  p.gates_m = {60.0, 80.0, 160.0};
  p.mounting.offset_m = {-2.0, 0.3, 2.0};
  p.mounting.tilt_rad = 0.05;
  return p;
}

/// Calls check for every measurement of 60 s.
template <class Check>
int each_measurement(LidarSim& lidar, Check&& check) {
  LidarMeasurement m;
  int count = 0;
  for (int n = 0; n <= 4800; ++n) {
    if (!lidar.step(n, {}, m)) continue;
    check(m);
    ++count;
  }
  return count;
}

// Still air, all six motions: the line-of-sight speed is n . V with the reported direction,
// attitude and velocity, to rounding, in every gate; and that velocity moves the reported
// position (over one scan, mean of the velocities against the way, 2 cm/s of curvature).
TEST(LidarMotionTest, StillAirShowsTheMotionAlone) {
  const FunctionWind wind(still);
  LidarParams p = four_beams();
  p.platform = rough_sea(0.06);
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement before;
  double fastest_mps = 0.0;
  const int count = each_measurement(lidar, [&](const LidarMeasurement& m) {
    const double expected = dot(m.beam_dir_I(), m.velocity_I_mps);
    for (std::size_t g = 0; g < 3; ++g) EXPECT_NEAR(m.gates[g].speed_mps, expected, 1e-12);
    fastest_mps = std::max(fastest_mps, std::abs(expected));
    if (before.time_s > 0.0) {
      const Vec3 mean_mps = 0.5 * (m.velocity_I_mps + before.velocity_I_mps);
      const Vec3 way_m = m.position_I_m - before.position_I_m;
      EXPECT_LT(norm(way_m - (m.time_s - before.time_s) * mean_mps), 0.005);
    }
    before = m;
  });
  EXPECT_EQ(count, 240);
  EXPECT_GT(fastest_mps, 1.0);
}

// Pitch alone, by hand: theta = 0.06 sin(2 pi t/25) about the foot; a lidar at hub height that
// looks along the rotor axis sees -h theta' (up-wind is -x, positive theta' moves it down-wind,
// away from what is ahead of it).
TEST(LidarMotionTest, PitchingTower) {
  const FunctionWind wind(still);
  LidarParams p;
  p.scan.beams = {{}};
  p.gates_m = {100.0};
  p.platform.freedoms[kPlatformPitch].harmonics = {{0.06, 25.0, 0.0}};
  LidarSim lidar(p, wind, kSetting);
  each_measurement(lidar, [&](const LidarMeasurement& m) {
    const double omega = 2.0 * kPi / 25.0;
    EXPECT_NEAR(m.gates[0].speed_mps, -90.0 * 0.06 * omega * std::cos(omega * m.time_s), 1e-12);
    EXPECT_NEAR(m.pitch_rad, -0.06 * std::sin(omega * m.time_s), 1e-12);
    EXPECT_NEAR(m.yaw_rad, kPi, 1e-12);
  });
}

// Uniform oblique wind from the moving platform: n . (V - U), so that motion compensation with
// what the measurement says gives the wind along the beam back.
TEST(LidarMotionTest, UniformWindIsRecovered) {
  const FunctionWind wind(oblique);
  for (const MountingPlace place : {MountingPlace::kNacelle, MountingPlace::kSpinner}) {
    LidarParams p = four_beams();
    p.platform = rough_sea(0.06);
    p.mounting.tower_slope = 1.5;
    p.mounting.place = place;
    LidarSim lidar(p, wind, kSetting);
    LidarMeasurement m;
    for (int n = 0; n <= 800; ++n) {
      const double t = kStep_s * n;
      const TurbineState turbine{0.4 * std::sin(t), 0.4 * std::cos(t), 1.2 * t, 1.2, 0.0, 0.0};
      if (!lidar.step(n, turbine, m)) continue;
      const Vec3 dir = m.beam_dir_I();
      EXPECT_NEAR(m.gates[0].speed_mps - dot(dir, m.velocity_I_mps),
                  -dot(dir, Vec3{12.0, 3.0, -1.5}), 1e-12);
    }
  }
}

// One beam 15 deg off the axis on a spinner that turns at 1.2 rad/s, up at azimuth 0, in wind from
// the side: it sees 12 cos 15 + (3 sin(azimuth) + 1.5 cos(azimuth)) sin 15 by hand, as it looks
// to the right (-y) at 90 deg; a lidar on the nacelle sees 12 cos 15 + 1.5 sin 15 all the time.
TEST(LidarMotionTest, SpinnerScansByItself) {
  const FunctionWind wind(oblique);
  LidarParams p;
  p.scan.beams = {{0.0, rad_from_deg(15.0), 0.0, {}}};
  p.gates_m = {100.0};
  p.mounting.place = MountingPlace::kSpinner;
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  const double c = std::cos(rad_from_deg(15.0)), s = std::sin(rad_from_deg(15.0));
  for (int n = 0; n <= 800; ++n) {
    TurbineState turbine;
    turbine.rotor_speed_radps = 1.2;
    turbine.azimuth_rad = std::fmod(1.2 * kStep_s * n, 2.0 * kPi);
    if (!lidar.step(n, turbine, m)) continue;
    const double a = 1.2 * m.time_s;
    EXPECT_NEAR(m.gates[0].speed_mps, 12.0 * c + (3.0 * std::sin(a) + 1.5 * std::cos(a)) * s, 1e-9);
  }
}

// Averaged over the beam time as well: mean speed and mean velocity belong together, so that a
// surging lidar in still air is compensated to rounding (no rotation).
TEST(LidarMotionTest, MeanSpeedGoesWithMeanVelocity) {
  const FunctionWind wind(still);
  LidarParams p = four_beams();
  p.scan.samples_per_beam = 8;
  p.platform.freedoms[kSurge].harmonics = {{2.0, 3.0, 0.3}};
  LidarSim lidar(p, wind, kSetting);
  each_measurement(lidar, [&](const LidarMeasurement& m) {
    EXPECT_NEAR(m.gates[1].speed_mps, dot(m.beam_dir_I(), m.velocity_I_mps), 1e-12);
    const double omega = 2.0 * kPi / 3.0;
    // Mean of the velocity over the beam time, from the way; eight midpoints are within 0.2 %.
    const double way_m =
        2.0 * (std::sin(omega * m.time_s + 0.3) - std::sin(omega * (m.time_s - 0.25) + 0.3));
    EXPECT_NEAR(m.velocity_I_mps.x, way_m / 0.25, 0.01);
  });
}

// A platform that yaws by 20 deg sin(2 pi t/40 s) takes beam 1, 15 deg to the left and up, out of
// a field of +-60 m: refused before the run, for its measurement at 1.25 s, by hand; the one at
// 0.25 s and that of beam 2 at 0.5 s are still inside.
TEST(LidarMotionTest, PlatformTakesABeamOutOfTheField) {
  WindExtent extent;
  extent.y_min_m = -60.0;
  extent.y_max_m = 60.0;
  const FunctionWind wind(oblique, extent);
  LidarParams p = four_beams();
  p.gates_m = {160.0};
  p.mounting.offset_m = {};
  p.mounting.tilt_rad = 0.0;
  EXPECT_EQ(test::error_text([&] { LidarSim(p, wind, kSetting); }), "no error");
  p.platform.freedoms[kYaw].harmonics = {{rad_from_deg(20.0), 40.0, 0.0}};
  const auto side_m = [](double t) {
    const double reach_m = 160.0 + 3.0 * 30.0 / 2.354820045;
    const double yaw_rad = rad_from_deg(20.0) * std::sin(2.0 * kPi * t / 40.0);
    return reach_m * std::cos(rad_from_deg(15.0)) * std::sin(rad_from_deg(15.0) + yaw_rad);
  };
  ASSERT_LT(side_m(0.5), 60.0);
  std::ostringstream expected;
  expected << "lidar: beam 1, gate 1 (with its range weighting) leaves the wind field by "
           << side_m(1.25) - 60.0 << " m sideways at t = 1.25 s; the field must be wider";
  EXPECT_EQ(test::error_text([&] { LidarSim(p, wind, kSetting); }), expected.str());
}

// What cannot be known before the run is found in it: a tower top that bends far.
TEST(LidarMotionTest, TowerTakesABeamOutOfTheField) {
  WindExtent extent;
  extent.z_max_m = 140.0;
  const FunctionWind wind(oblique, extent);
  LidarParams p;
  p.scan.beams = {{0.0, rad_from_deg(10.0), 0.0, {}}};
  p.gates_m = {200.0};
  p.mounting.tower_slope = 2.0;
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  EXPECT_TRUE(lidar.step(20, {}, m));
  // 2 x 2.5/90 rad more: the far end rises from 131.4 to 144 m.
  const double reach_m = 200.0 + 3.0 * 30.0 / 2.354820045;
  const double too_high_m = 50.0 - reach_m * std::sin(rad_from_deg(10.0) + 2.0 * 2.5 / 90.0);
  ASSERT_LT(too_high_m, -1.0);
  std::ostringstream expected;
  expected << "lidar: beam 1, gate 1 (with its range weighting) leaves the wind field by "
           << -too_high_m << " m in height at t = 0.5 s";
  EXPECT_THAT(test::error_text([&] {
                lidar.step(40, {2.5, 0.0, 0.0, 0.0, 0.0, 0.0}, m);
              }),
              HasSubstr(expected.str()));
}

}  // namespace
}  // namespace lac::sim
