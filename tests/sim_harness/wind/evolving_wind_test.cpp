// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/evolving_wind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"

namespace lac::sim {
namespace {

/// The same speed everywhere, rising by 1 m/s per second.
GriddedWind ramp(double start_mps, int nt = 10) {
  VelocityGrid grid({2, 2, nt, 100.0, 100.0, 1.0, 40.0, 90.0, 16.0, false});
  for (int it = 0; it < nt; ++it) {
    for (int point = 0; point < 4; ++point)
      grid.at(it, point / 2, point % 2, 0) = static_cast<float>(start_mps + it);
  }
  return GriddedWind(std::move(grid));
}

EvolvingWind three_planes() {
  std::vector<WindPlane> planes;
  planes.push_back({0.0, ramp(10.0)});
  planes.push_back({50.0, ramp(20.0)});
  planes.push_back({80.0, ramp(30.0)});
  return EvolvingWind(std::move(planes));
}

// A point sees the nearest plane, at the time its air arrives at the rotor (t - x / U); down-wind
// of the rotor and beyond the last plane the outer planes hold.
TEST(EvolvingWind, NearestPlaneAtTheTimeOfArrival) {
  const EvolvingWind wind = three_planes();
  const auto u = [&](double x_m) { return wind.velocity({x_m, 0.0, 90.0}, 2.0).x; };
  EXPECT_EQ(u(0.0), 12.0);
  EXPECT_EQ(u(16.0), 11.0);
  EXPECT_EQ(u(-16.0), 13.0);
  EXPECT_NEAR(u(-25.0), 12.0 + 25.0 / 16.0, 1e-5);
  EXPECT_NEAR(u(-26.0), 22.0 + 26.0 / 16.0, 1e-5);
  EXPECT_NEAR(u(-64.0), 22.0 + 4.0, 1e-5);
  EXPECT_NEAR(u(-66.0), 32.0 + 66.0 / 16.0, 1e-5);
  EXPECT_NEAR(u(-100.0), 32.0 + 100.0 / 16.0, 1e-5);
}

// Extent, mean speed and disk points are those of the planes.
TEST(EvolvingWind, ExtentOfThePlanes) {
  const EvolvingWind wind = three_planes();
  EXPECT_EQ(wind.mean_speed_mps(), 16.0);
  EXPECT_EQ(wind.extent().y_max_m, 50.0);
  EXPECT_EQ(wind.time_end_s(), 9.0);
  EXPECT_EQ(wind.disk_points(90.0, 80.0).size(), 4U);
  EXPECT_EQ(wind.planes().size(), 3U);
}

std::string refusal(double first_m, double second_m, int nt) {
  std::vector<WindPlane> planes;
  planes.push_back({first_m, ramp(10.0)});
  planes.push_back({second_m, ramp(20.0, nt)});
  try {
    const EvolvingWind wind(std::move(planes));
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

// Planes must begin at the rotor, rise, and lie on one grid.
TEST(EvolvingWind, RefusesPlanesThatDoNotFit) {
  EXPECT_EQ(refusal(0.0, 10.0, 10), "none");
  EXPECT_THAT(refusal(5.0, 10.0, 10), testing::HasSubstr("first plane [m] = 5"));
  EXPECT_THAT(refusal(0.0, 0.0, 10), testing::HasSubstr("distance of a plane [m] = 0"));
  EXPECT_THAT(refusal(0.0, 10.0, 11), testing::HasSubstr("another grid = 1"));
  EXPECT_THROW(EvolvingWind({}), Error);
}

}  // namespace
}  // namespace lac::sim
