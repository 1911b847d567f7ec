// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/turned_wind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/units.hpp"
#include "sim_harness/wind/uniform_wind.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

/// Shows the position it is asked for, W or I: u = x, v = y, w = z + 1000 t.
class Probe final : public WindField {
 public:
  explicit Probe(WindExtent extent = {}) : extent_(extent) {}
  Vec3 velocity(const Vec3& p, double t) const override { return {p.x, p.y, p.z + 1000.0 * t}; }
  double mean_speed_mps() const override { return 10.0; }
  WindExtent extent() const override { return extent_; }

 private:
  WindExtent extent_;
};

TurnedWind turned(std::unique_ptr<const WindField> field, double yaw_deg, double upflow_deg,
                  double reach_m = 250.0) {
  return {std::move(field), 90.0, {rad_from_deg(yaw_deg), rad_from_deg(upflow_deg), reach_m}};
}

void expect_near(const Vec3& a, const Vec3& b, double error) {
  EXPECT_NEAR(a.x, b.x, error);
  EXPECT_NEAR(a.y, b.y, error);
  EXPECT_NEAR(a.z, b.z, error);
}

// A steady wind of 10 m/s, by hand: 30 deg of yaw blow to the right, 10 deg of upflow upwards; and
// both: (cos 30 cos 10, -sin 30 cos 10, sin 10).
TEST(TurnedWind, DirectionOfTheMeanWind) {
  const auto steady = [] { return std::make_unique<UniformWind>(UniformWindParams{}); };
  const Vec3 point{-50.0, 20.0, 100.0};
  expect_near(turned(steady(), 30.0, 0.0).velocity(point, 1.0), {8.660254, -5.0, 0.0}, 1e-6);
  expect_near(turned(steady(), 0.0, 10.0).velocity(point, 1.0), {9.848078, 0.0, 1.736482}, 1e-6);
  expect_near(turned(steady(), 30.0, 10.0).velocity(point, 1.0), {8.528685, -4.924039, 1.736482},
              1e-6);
  EXPECT_NEAR(turned(steady(), 30.0, 10.0).mean_speed_mps(), 8.528685, 1e-6);
}

// Yaw of 90 deg less a bit cannot be; 60 deg by hand: 100 m up-wind of the rotor on its axis is
// 50 m up-wind and 86.6 m to the right in the frame of the wind, since the wind comes from the left
// and the axis point lies to its right. What W has there, (-50, -86.6), is turned back:
// x = -50 cos 60 + (-86.6) sin 60 = -100, y = 50 sin 60 - 86.6 cos 60 = 0.
TEST(TurnedWind, PositionsTurnWithTheWind) {
  struct Spy final : WindField {
    mutable Vec3 asked;
    Vec3 velocity(const Vec3& p, double) const override { return asked = p, Vec3{}; }
    double mean_speed_mps() const override { return 10.0; }
  };
  auto spy = std::make_unique<Spy>();
  const Spy& seen = *spy;
  const TurnedWind wind = turned(std::move(spy), 60.0, 0.0);
  wind.velocity({-100.0, 0.0, 90.0}, 0.0);
  expect_near(seen.asked, {-50.0, -86.602540, 90.0}, 1e-6);
}

// A turn is a rotation about the rotor centre: position in, velocity out. With a field that shows
// positions, turning there and back gives the position itself.
TEST(TurnedWind, ThereAndBackAgain) {
  const TurnedWind wind = turned(std::make_unique<Probe>(), 25.0, -7.0);
  const Vec3 p{-120.0, 33.0, 61.0};
  const Vec3 v = wind.velocity(p, 0.0);
  const double lift = 90.0;  // the probe's z counts from the ground
  const Rotation turn = rotation_from_roll_pitch_yaw(0.0, rad_from_deg(7.0), rad_from_deg(-25.0));
  expect_near(v, p - Vec3{0.0, 0.0, lift} + lift * (turn * Vec3{0.0, 0.0, 1.0}), 1e-9);
}

// The extent that is promised: every point of it, from the rotor to the reach, is asked for inside
// of the field; and it is not given away: the corners come within a metre of the field's border.
TEST(TurnedWind, ExtentStaysInsideTheField) {
  const WindExtent inner{-200.0, 200.0, 10.0, 190.0, 0.0, 600.0};
  const double angles[3][2] = {{20.0, 0.0}, {0.0, 10.0}, {-15.0, 5.0}};
  for (const auto& [yaw, upflow] : angles) {
    struct Watch final : WindField {
      WindExtent e;
      mutable double least_y = 1e9, least_z = 1e9, least_t = 1e9;
      Vec3 velocity(const Vec3& p, double t) const override {
        const double arrival = t - p.x / 10.0;
        least_y = std::min({least_y, p.y - e.y_min_m, e.y_max_m - p.y});
        least_z = std::min({least_z, p.z - e.z_min_m, e.z_max_m - p.z});
        least_t = std::min({least_t, arrival - e.t_min_s, e.t_max_s - arrival});
        return {};
      }
      double mean_speed_mps() const override { return 10.0; }
      WindExtent extent() const override { return e; }
    };
    auto watch = std::make_unique<Watch>();
    watch->e = inner;
    const Watch& seen = *watch;
    const TurnedWind wind = turned(std::move(watch), yaw, upflow, 150.0);
    const WindExtent e = wind.extent();
    EXPECT_EQ(e.t_min_s, 0.0);
    for (const double x : {-150.0, 0.0}) {
      for (const double y : {e.y_min_m, e.y_max_m}) {
        for (const double z : {e.z_min_m, e.z_max_m}) {
          for (const double arrival : {e.t_min_s, e.t_max_s})
            wind.velocity({x, y, z}, arrival + x / wind.mean_speed_mps());
        }
      }
    }
    for (const double least : {seen.least_y, seen.least_z, seen.least_t}) {
      EXPECT_GE(least, -1e-9) << yaw << ' ' << upflow;
      EXPECT_LT(least, 1.0) << yaw << ' ' << upflow;
    }
  }
}

// A uniform wind has one point; turned, the rotor cuts through planes that arrive one after the
// other, so the disk needs its raster.
TEST(TurnedWind, DiskHasManyPoints) {
  const TurnedWind wind = turned(std::make_unique<UniformWind>(UniformWindParams{}), 10.0, 0.0);
  EXPECT_EQ(wind.disk_points(90.0, 63.0).size(), 497u);
}

// Angles that cannot be, and a field that is too narrow for the reach.
TEST(TurnedWind, Refuses) {
  const auto error = [](double yaw_deg, double upflow_deg) {
    const WindExtent small{-70.0, 70.0, 20.0, 160.0, 0.0, 600.0};
    return test::error_text(
        [&] { turned(std::make_unique<Probe>(small), yaw_deg, upflow_deg, 250.0); });
  };
  EXPECT_THAT(error(80.0, 0.0), HasSubstr("turned wind: yaw [deg] = 80, expected between"));
  EXPECT_THAT(error(0.0, -95.0), HasSubstr("upflow [deg] = -95"));
  EXPECT_THAT(error(20.0, 0.0), HasSubstr("width left [m] = -33.0002"));
  EXPECT_THAT(error(0.0, 20.0), HasSubstr("height left [m]"));
  EXPECT_THAT(error(5.0, 0.0), HasSubstr("no error"));
}

}  // namespace
}  // namespace lac::sim
