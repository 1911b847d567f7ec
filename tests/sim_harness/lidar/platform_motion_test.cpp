// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/platform_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

class PlatformMotionTest : public ::testing::Test {
 protected:
  PlatformMotion read(const std::string& text) {
    YamlReader in = YamlReader::load(folder_.write("case.yaml", text));
    PlatformMotion platform = read_platform_motion(in);
    in.finish();
    return platform;
  }
  std::string error_of(const std::string& text) {
    return test::error_text([&] { read(text); });
  }

  test::TempFolder folder_;
};

constexpr char kAll[] =
    "reference_height_m: -10\n"
    "surge: {mean: 2, amplitude: [1.5, 0.2], period_s: [12, 3], phase_deg: [0, 70]}\n"
    "sway: {amplitude: [0.8], period_s: [9]}\n"
    "heave: {amplitude: [0.5], period_s: [11], phase_deg: [40]}\n"
    "roll: {amplitude: [3], period_s: [14], phase_deg: [-90]}\n"
    "pitch: {mean: 4, amplitude: [5], period_s: [25]}\n"
    "yaw: {amplitude: [6], period_s: [60], phase_deg: [30]}\n";

// Two harmonics and a mean, by hand at t = 2 s.
TEST_F(PlatformMotionTest, Harmonics) {
  const PlatformMotion p = read(kAll);
  const Motion surge = p.freedoms[kSurge].at(2.0);
  const double a = 2.0 * kPi * 2.0 / 12.0, b = 2.0 * kPi * 2.0 / 3.0 + rad_from_deg(70.0);
  EXPECT_NEAR(surge.value, 2.0 + 1.5 * std::sin(a) + 0.2 * std::sin(b), 1e-12);
  EXPECT_NEAR(surge.rate, 2.0 * kPi * (1.5 / 12.0 * std::cos(a) + 0.2 / 3.0 * std::cos(b)), 1e-12);
  EXPECT_NEAR(p.freedoms[kPlatformPitch].at(0.0).value, rad_from_deg(4.0), 1e-12);
}

// All six at once: the velocity of a point far from the reference point is the slope of its
// position over time (central difference of 20 ms, error below 1e-5 m/s), at forty times.
TEST_F(PlatformMotionTest, VelocityIsTheSlopeOfThePosition) {
  const PlatformMotion p = read(kAll);
  const Vec3 point{-3.0, 1.5, 100.0};
  for (double t = 0.5; t < 40.0; t += 1.0) {
    const double h = 0.01;
    const Vec3 slope =
        (0.5 / h) * (p.frame_at(t + h).position_I_m(point) - p.frame_at(t - h).position_I_m(point));
    const Vec3 v = p.frame_at(t).velocity_at_I_mps(point);
    EXPECT_NEAR(norm(v - slope), 0.0, 2e-4) << t;
    EXPECT_GT(norm(v), 0.05) << t;
  }
}

// Pitch alone, nose down: a point 100 m above the reference goes to x = 100 sin(theta).
TEST_F(PlatformMotionTest, PitchAlone) {
  const PlatformMotion p = read("pitch: {mean: 10}\n");
  const Vec3 x = p.frame_at(3.0).position_I_m({0.0, 0.0, 100.0});
  EXPECT_NEAR(x.x, 100.0 * std::sin(rad_from_deg(10.0)), 1e-12);
  EXPECT_NEAR(x.z, 100.0 * std::cos(rad_from_deg(10.0)), 1e-12);
}

// A table is met in its rows, a straight line is one in between, and the rate is the slope of the
// curve; outside the table the run is refused.
TEST_F(PlatformMotionTest, Table) {
  std::string table = "# time surge sway heave roll pitch yaw\n";
  for (int i = 0; i <= 20; ++i) {
    const double t = 0.5 * i;
    table += std::to_string(t) + " " + std::to_string(std::sin(t)) + " " + std::to_string(0.3 * t) +
             " 0 0 " + std::to_string(2.0 * t) + " 0\n";
  }
  folder_.write("motion.txt", table);
  const PlatformMotion p = read("table: motion.txt\n");
  EXPECT_NEAR(p.freedoms[kSurge].at(2.5).value, std::sin(2.5), 1e-6);
  EXPECT_NEAR(p.freedoms[kSurge].at(10.0).value, std::sin(10.0), 1e-6);
  for (double t = 0.05; t < 10.0; t += 0.1) {
    EXPECT_NEAR(p.freedoms[kSway].at(t).value, 0.3 * t, 1e-9);
    EXPECT_NEAR(p.freedoms[kSway].at(t).rate, 0.3, 1e-6);
    EXPECT_NEAR(p.freedoms[kPlatformPitch].at(t).value, rad_from_deg(2.0 * t), 1e-9);
    EXPECT_NEAR(p.freedoms[kSurge].at(t).value, std::sin(t), 0.02);
    const double h = 1e-6;
    const double slope =
        (p.freedoms[kSurge].at(t + h).value - p.freedoms[kSurge].at(t - h).value) / (2.0 * h);
    EXPECT_NEAR(p.freedoms[kSurge].at(t).rate, slope, 1e-6) << t;
  }
  EXPECT_EQ(test::error_text([&] { p.require_until(10.0); }), "no error");
  EXPECT_THAT(test::error_text([&] { p.require_until(12.0); }),
              HasSubstr("runs from 0 to 10 s, expected 0 to 12 s"));
}

// The bound on the way holds over the whole motion, and is no more than twice what happens.
TEST_F(PlatformMotionTest, GreatestTravel) {
  const PlatformMotion p = read(kAll);
  const Vec3 point{0.0, 0.0, 100.0};
  double farthest_m = 0.0;
  for (double t = 0.0; t < 600.0; t += 0.1) {
    const Vec3 way = p.frame_at(t).position_I_m(point) - Vec3{0.0, 0.0, 90.0};
    farthest_m = std::max(farthest_m, norm(way));
  }
  EXPECT_GE(p.greatest_travel_m(100.0), farthest_m);
  EXPECT_LE(p.greatest_travel_m(100.0), 2.0 * farthest_m);
}

// Lists that do not fit together, angles that no platform has, tables that are none.
TEST_F(PlatformMotionTest, Faults) {
  EXPECT_EQ(error_of("reference_height_m: 0\n"), "no error");
  EXPECT_THAT(error_of("surge: {amplitude: [1, 2], period_s: [10]}\n"),
              HasSubstr("case.yaml:1: surge.period_s: found 1 values, expected 2, one per "
                        "amplitude"));
  EXPECT_THAT(error_of("surge: {amplitude: [1], period_s: [0]}\n"),
              HasSubstr("surge.period_s: found 0"));
  EXPECT_THAT(error_of("pitch: {amplitude: [60], period_s: [10]}\n"),
              HasSubstr("pitch.amplitude: found 60"));
  EXPECT_THAT(error_of("pitsch: {amplitude: [6], period_s: [10]}\n"),
              HasSubstr("pitsch: unknown key (did you mean 'pitch'?)"));
  folder_.write("motion.txt", "0 0 0 0 0 0 0\n0 1 0 0 0 0 0\n");
  EXPECT_THAT(error_of("table: motion.txt\n"),
              HasSubstr("motion.txt:2: expected a time after that of the row before"));
  folder_.write("motion.txt", "0 0 0 0 0 0 0\n1 1 0 0 0 50 0\n");
  EXPECT_THAT(error_of("table: motion.txt\n"), HasSubstr("motion.txt:2: pitch: found 50"));
  folder_.write("motion.txt", "0 0 0 0 0 0\n");
  EXPECT_THAT(error_of("table: motion.txt\n"), HasSubstr("motion.txt:1: found 6 numbers"));
  folder_.write("motion.txt", "0 0 0 0 0 0 0\n");
  EXPECT_THAT(error_of("table: motion.txt\n"), HasSubstr("found one row"));
  folder_.write("motion.txt", "0 0 0 0 0 0 0\n900 0 0 0 0 0 0\n");
  EXPECT_THAT(error_of("table: motion.txt\nsurge: {mean: 1}\n"), HasSubstr("surge: unknown key"));
}

}  // namespace
}  // namespace lac::sim
