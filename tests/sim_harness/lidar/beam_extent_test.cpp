// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/beam_extent.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "sim_harness/lidar/function_wind.hpp"
#include "sim_harness/lidar/lidar_sim.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

/// Remembers where it was asked.
class AskedWind final : public WindField {
 public:
  Vec3 velocity(const Vec3& p, double) const override {
    asked.push_back(p);
    return {10.0, 0.0, 0.0};
  }
  double mean_speed_mps() const override { return 10.0; }
  bool holds(const Vec3& p) const override { return p.x > kept_from_x_m; }

  mutable std::vector<Vec3> asked;
  double kept_from_x_m = -1e9;
};

LidarParams two_beams() {
  LidarParams p;
  const double a = rad_from_deg(15.0);
  p.scan.beams = {{a, a, 0.0, {}}, {-a, -a, 0.0, {}}};
  p.gates_m = {60.0, 80.0, 160.0};
  p.mounting.offset_m = {-2.0, 0.3, 2.0};
  return p;
}

const LidarSetting kSetting{90.0, 0.0125, 60.0};

std::string error_of(const LidarParams& p, const WindField& wind = AskedWind()) {
  return test::error_text([&] { LidarSim(p, wind, kSetting); });
}

// The centre of a gate may not lie behind the rotor plane: a lidar 5 m behind it, range 4 m.
TEST(BeamExtentTest, GateBehindTheRotor) {
  LidarParams p;
  p.scan.beams = {{}, {}};
  p.scan.beams[1].gates_m = {4.0, 50.0};
  p.gates_m = {50.0};
  p.weighting.fwhm_m = 0.0;
  p.mounting.offset_m = {5.0, 0.0, 3.0};
  EXPECT_EQ(error_of(p),
            "lidar: beam 2, gate 1 lies 1 m behind the rotor plane, expected up-wind of it");
  p.scan.beams[1].gates_m = {6.0, 50.0};
  EXPECT_EQ(error_of(p), "no error");
}

// A beam 30 deg down from 90 m meets the ground after 180 m; the volume of the gate counts.
TEST(BeamExtentTest, BeamIntoTheGround) {
  LidarParams p;
  p.scan.beams = {{0.0, rad_from_deg(-30.0), 0.0, {}}};
  p.weighting.fwhm_m = 0.0;
  p.gates_m = {100.0, 179.0};
  EXPECT_EQ(error_of(p), "no error");
  p.gates_m = {100.0, 184.0};
  EXPECT_EQ(error_of(p),
            "lidar: beam 1, gate 2 (with its range weighting) reaches 2 m into the ground");
  p.gates_m = {160.0};  // and three sigma, 38.2 m
  p.weighting.fwhm_m = 30.0;
  EXPECT_THAT(error_of(p), HasSubstr("beam 1, gate 1 (with its range weighting) reaches 9.109"));
}

// A gate so near that three sigma of its volume lie behind the lidar: 38.2 m against 30 m.
TEST(BeamExtentTest, VolumeBehindTheLidar) {
  LidarParams p;
  p.scan.beams = {{}};
  p.gates_m = {30.0};
  EXPECT_THAT(error_of(p), HasSubstr("lidar: beam 1, gate 1: its range weighting reaches 8.219"));
  p.gates_m = {38.3};
  EXPECT_EQ(error_of(p), "no error");
}

// A field that was thinned for another lidar: the first gate that reaches beyond what is kept.
TEST(BeamExtentTest, WindThatWasNotKept) {
  AskedWind wind;
  wind.kept_from_x_m = -100.0;
  EXPECT_EQ(error_of(two_beams(), wind),
            "lidar: beam 1, gate 2: the wind was not kept there, the field was thinned for another "
            "lidar");
}

double distance_to_nearest(const Vec3& p, const std::vector<Vec3>& points) {
  double nearest_m = 1e9;
  for (const Vec3& q : points) nearest_m = std::min(nearest_m, norm(p - q));
  return nearest_m;
}

// What a lidar asks for is what it said it would: at rest each of its points, to rounding, and no
// other; the gate centres with their numbers.
TEST(BeamExtentTest, DemandIsWhatIsAsked) {
  for (const ProbeKind kind : {ProbeKind::kGaussian, ProbeKind::kLorentzian}) {
    LidarParams p = two_beams();
    p.weighting.kind = kind;
    p.weighting.reach_rayleigh = 3.0;
    p.mounting.tower_travel_m = 3.0;  // one position of it
    const WindDemand demand = wind_demand(p, 90.0);
    const AskedWind wind;
    LidarSim lidar(p, wind, kSetting);
    LidarMeasurement m;
    for (int n = 0; n <= 40; ++n) lidar.step(n, {}, m);
    ASSERT_EQ(wind.asked.size(), demand.points_I_m.size());
    for (const Vec3& point : wind.asked) {
      EXPECT_LT(distance_to_nearest(point, demand.points_I_m), 1e-9);
    }
    ASSERT_EQ(demand.gates.size(), 6U);
    EXPECT_EQ(demand.gates[4].beam, 2);
    EXPECT_EQ(demand.gates[4].gate, 2);
    EXPECT_NEAR(norm(demand.gates[4].position_I_m - Vec3{-2.0, 0.3, 92.0}), 80.0, 1e-9);
    EXPECT_EQ(demand.margin_m, 3.0);
  }
}

// With platform, bending tower and spinner every point asked for lies within the margin of one
// that was announced; the margin is not wildly too large.
TEST(BeamExtentTest, MarginCoversMotion) {
  for (const MountingPlace place : {MountingPlace::kNacelle, MountingPlace::kSpinner}) {
    LidarParams p = two_beams();
    p.mounting.place = place;
    p.mounting.tower_slope = 1.5;
    p.platform.freedoms[kSurge].harmonics = {{2.0, 12.0, 0.3}};
    p.platform.freedoms[kPlatformPitch].harmonics = {{0.04, 25.0, 2.0}};
    p.platform.freedoms[kYaw].mean = 0.05;
    const WindDemand demand = wind_demand(p, 90.0);
    const AskedWind wind;
    LidarSim lidar(p, wind, kSetting);
    LidarMeasurement m;
    double farthest_m = 0.0;
    for (int n = 0; n <= 2400; ++n) {
      const double t = 0.0125 * n;
      lidar.step(n, {2.0 * std::sin(t), 2.0 * std::cos(t), 1.2 * t, 1.2, 0.0, 0.0}, m);
    }
    for (const Vec3& point : wind.asked) {
      farthest_m = std::max(farthest_m, distance_to_nearest(point, demand.points_I_m));
    }
    EXPECT_LE(farthest_m, demand.margin_m);
    EXPECT_GE(farthest_m, 0.05 * demand.margin_m);
  }
}

// A tower top that moves 10 m either way: every point asked for lies within the margin of one that
// was announced. With 3 m allowed it does not.
TEST(BeamExtentTest, RoomForTheTower) {
  LidarParams p = two_beams();
  p.mounting.tower_slope = 1.5;
  const AskedWind wind;
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  for (int n = 0; n <= 2400; ++n) {
    lidar.step(n, {.tower_x_m = 10.0 * std::sin(0.00625 * n)}, m);
  }
  for (const double travel_m : {3.0, 10.0}) {
    p.mounting.tower_travel_m = travel_m;
    const WindDemand demand = wind_demand(p, 90.0);
    double farthest_m = 0.0;
    for (const Vec3& point : wind.asked) {
      farthest_m = std::max(farthest_m, distance_to_nearest(point, demand.points_I_m));
    }
    EXPECT_EQ(farthest_m <= demand.margin_m, travel_m == 10.0);
    EXPECT_LT(demand.margin_m, 14.0);
  }
}

// A tower that bends farther than the field was kept for: beam, gate, time and bend are named.
TEST(BeamExtentTest, TowerLeavesWhatWasKept) {
  AskedWind wind;
  LidarParams p = two_beams();
  LidarSim lidar(p, wind, kSetting);
  wind.kept_from_x_m = -100.0;  // the second gate, at -77 m and 38 m wide, reaches there
  LidarMeasurement m;
  const std::string error = test::error_text([&] { lidar.step(20, {.tower_x_m = -5.8}, m); });
  EXPECT_THAT(error,
              HasSubstr("lidar: beam 1, gate 2 (with its range weighting) at t = 0.25 s: the "
                        "wind was not kept at x = -1"));
  EXPECT_THAT(error, HasSubstr("the tower top stands -5.8 m off its place, lidar.tower_travel_m"));
}

// A beam 10 deg down ends 48 m over the ground, 238 m away. A tower that bends 11 m up-wind turns
// it by 14 deg more into the ground, found when it happens; a platform that leans as far, before
// the run.
TEST(BeamExtentTest, MotionIntoTheGround) {
  LidarParams p;
  p.scan.beams = {{0.0, rad_from_deg(-10.0), 0.0, {}}};
  p.gates_m = {200.0};
  p.mounting.tower_slope = 2.0;
  const AskedWind wind;
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  EXPECT_THAT(test::error_text([&] { lidar.step(20, {.tower_x_m = 11.0}, m); }), "no error");
  EXPECT_THAT(test::error_text([&] { lidar.step(40, {.tower_x_m = -11.0}, m); }),
              HasSubstr("beam 1, gate 1 (with its range weighting) reaches "));
  p.platform.freedoms[kPlatformPitch].mean = -rad_from_deg(14.0);
  EXPECT_THAT(error_of(p), HasSubstr(" m into the ground at t = "));
}

// A point 25 m off the axis of a spinner: of 72 positions the ones nearest to the side are 2.5 deg
// off it, at 24.98 m and inside the field; between them it leaves by 1 cm.
TEST(BeamExtentTest, SpinnerBetweenPositions) {
  LidarParams p;
  p.scan.beams = {{}};
  p.scan.beams[0].azimuth_rad = std::asin(0.25);
  p.gates_m = {100.0};
  p.weighting.fwhm_m = 0.0;
  p.mounting.place = MountingPlace::kSpinner;
  p.mounting.roll_rad = rad_from_deg(2.5);
  WindExtent extent;
  extent.y_max_m = 25.0 - 0.01;
  extent.y_min_m = -extent.y_max_m;
  const test::FunctionWind wind([](const Vec3&, double) { return Vec3{10.0, 0.0, 0.0}; }, extent);
  ASSERT_LT(25.0 * std::cos(rad_from_deg(2.5)), extent.y_max_m);
  EXPECT_THAT(error_of(p, wind), HasSubstr("beam 1, gate 1 (with its range weighting) leaves the "
                                           "wind field by "));
}

// A field that begins with the run, and a first gate behind it: refused before the run.
TEST(BeamExtentTest, FirstSampleBeforeTheField) {
  LidarParams p;
  p.scan.beams = {{}};
  p.gates_m = {38.3};
  p.scan.beam_time_s = 0.25;
  p.mounting.offset_m = {38.0, 0.0, 0.0};
  WindExtent extent;
  extent.t_min_s = 0.0;
  const test::FunctionWind wind([](const Vec3&, double) { return Vec3{10.0, 0.0, 0.0}; }, extent);
  EXPECT_THAT(error_of(p, wind), HasSubstr("s at the start (t = 0.25 s)"));
}

// A field in which motion leaves between two instants that are sampled: every sample is planned
// for.
TEST(BeamExtentTest, EverySampleOfABeam) {
  LidarParams p;
  p.scan.beams = {{}};
  p.gates_m = {100.0};
  p.scan.beam_time_s = 10.0;
  p.scan.samples_per_beam = 10;                                // at 0.5, 1.5, ... 9.5 s
  p.platform.freedoms[kSway].harmonics = {{20.0, 20.0, 0.0}};  // 19.8 m at 4.5 and 5.5 s
  WindExtent extent;
  extent.y_max_m = 15.0;
  extent.y_min_m = -25.0;
  const test::FunctionWind wind([](const Vec3&, double) { return Vec3{10.0, 0.0, 0.0}; }, extent);
  const LidarSetting setting{90.0, 0.0125, 10.0};
  EXPECT_THAT(test::error_text([&] { LidarSim(p, wind, setting); }),
              HasSubstr("m sideways at t = 3.5 s"));
}

}  // namespace
}  // namespace lac::sim
