// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/evolving_wind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

/// The same speed everywhere, rising by 1 m/s per second.
VelocityGrid ramp(double start_mps, int nt = 10) {
  VelocityGrid grid({2, 2, nt, 100.0, 100.0, 1.0, 40.0, 90.0, 16.0, false});
  for (int it = 0; it < nt; ++it) {
    for (int point = 0; point < 4; ++point)
      grid.at(it, point / 2, point % 2, 0) = static_cast<float>(start_mps + it);
  }
  return grid;
}

ThinnedGrid whole(const VelocityGrid& grid) {
  return {grid, GridColumns(std::vector<bool>(grid.spec().plane_points(), true))};
}

EvolvingWind three_planes() {
  return EvolvingWind(
      {PlaneLayout({50.0, 80.0}), ramp(10.0), {whole(ramp(20.0)), whole(ramp(30.0))}});
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
  EXPECT_EQ(wind.layout().size(), 3U);
  EXPECT_EQ(wind.upwind_plane(2).column(0)[0], 30.0F);
}

/// Random numbers on 12 x 9 points.
VelocityGrid random_grid(unsigned seed) {
  VelocityGrid grid({12, 9, 20, 7.0, 8.0, 0.5, 58.0, 90.0, 16.0, true});
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> speed(-5.0F, 25.0F);
  for (int it = 0; it < 20; ++it) {
    for (float& value : grid.plane(it)) value = speed(random);
  }
  return grid;
}

// Within the margin of what was demanded the wind is that of the whole plane, to the last bit,
// also where the margin crosses to the next plane; the field says where that is.
TEST(EvolvingWind, ThinnedAsWhole) {
  const std::vector<VelocityGrid> grids{random_grid(1), random_grid(2), random_grid(3)};
  const PlaneLayout layout({50.0, 80.0});
  const WindDemand demand{{}, {{-63.0, 11.0, 80.0}, {-40.0, -38.5, 122.0}}, 3.0};
  const auto columns = demanded_columns(layout, grids[0].spec(), &demand);
  EXPECT_LT(columns[0].count(), 40U);
  const EvolvingWind thinned({layout, grids[0], {{grids[1], columns[0]}, {grids[2], columns[1]}}});
  std::vector<GriddedWind> planes(grids.begin(), grids.end());
  std::mt19937 random(4);
  std::uniform_real_distribution<double> offset(-3.0, 3.0), time(-30.0, 30.0);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = demand.points_I_m[i % 2] + Vec3{offset(random), offset(random), offset(random)};
    const double t = time(random);
    ASSERT_TRUE(thinned.holds(p));
    EXPECT_EQ(thinned.velocity(p, t), planes[layout.nearest(-p.x)].velocity(p, t));
  }
}

// Elsewhere up-wind the field holds nothing and says so; the rotor plane is whole.
TEST(EvolvingWind, RefusesWhatWasNotKept) {
  const VelocityGrid grid = random_grid(1);
  const WindDemand demand{{}, {{-63.0, 11.0, 80.0}}, 3.0};
  const PlaneLayout layout({60.0});
  const auto columns = demanded_columns(layout, grid.spec(), &demand);
  const EvolvingWind wind({layout, grid, {{grid, columns[0]}}});
  const Vec3 away{-63.0, -30.0, 80.0}, rotor{-20.0, -30.0, 80.0};
  EXPECT_FALSE(wind.holds(away));
  EXPECT_THAT(test::error_text([&] { wind.velocity(away, 0.0); }),
              testing::HasSubstr("x -63, y -30, z 80 m, which was not kept"));
  EXPECT_TRUE(wind.holds(rotor));
  EXPECT_EQ(wind.velocity(rotor, 3.0), GriddedWind(grid).velocity(rotor, 3.0));
}

// One grid per plane, all alike.
TEST(EvolvingWind, RefusesPlanesThatDoNotFit) {
  const PlaneLayout layout({50.0});
  EXPECT_THAT(test::error_text([&] {
                EvolvingWind({layout, ramp(10.0), {}});
              }),
              testing::HasSubstr("number of grids up-wind = 0"));
  EXPECT_THAT(test::error_text([&] {
                EvolvingWind({layout, ramp(10.0), {whole(ramp(20.0, 11))}});
              }),
              testing::HasSubstr("another grid = 1"));
}

}  // namespace
}  // namespace lac::sim
