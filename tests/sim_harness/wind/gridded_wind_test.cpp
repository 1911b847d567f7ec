// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/gridded_wind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "core/error.hpp"

namespace lac::sim {
namespace {

/// 40 m wide, heights 20 to 80 m, 10 steps of half a second, U = 16 m/s.
GridSpec small_spec(bool periodic) {
  GridSpec spec{5, 4, 10, 10.0, 20.0, 0.5, 20.0, 50.0, 16.0, periodic};
  return spec;
}

using Function = std::function<Vec3(double y_m, double z_m, double t_s)>;

GriddedWind filled(const GridSpec& spec, const Function& f) {
  VelocityGrid grid(spec);
  for (int it = 0; it < spec.nt; ++it) {
    for (int iz = 0; iz < spec.nz; ++iz) {
      for (int iy = 0; iy < spec.ny; ++iy) {
        const Vec3 v = f(spec.y_m(iy), spec.z_m(iz), it * spec.dt_s);
        grid.at(it, iz, iy, 0) = static_cast<float>(v.x);
        grid.at(it, iz, iy, 1) = static_cast<float>(v.y);
        grid.at(it, iz, iy, 2) = static_cast<float>(v.z);
      }
    }
  }
  return GriddedWind(std::move(grid));
}

/// Trilinear, a different one in each component.
Vec3 trilinear(double y, double z, double t) {
  return {16.0 + 0.1 * y - 0.02 * z + 0.3 * t, 0.001 * y * z - t, 0.002 * y * z * t};
}

// A function that is linear in each of y, z, t comes back to float accuracy (values below 10).
TEST(GriddedWind, ExactOnTrilinearFunctions) {
  const GriddedWind wind = filled(small_spec(false), trilinear);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> y(-20.0, 20.0), z(20.0, 80.0), t(0.0, 4.5);
  for (int i = 0; i < 1000; ++i) {
    const double yi = y(random), zi = z(random), ti = t(random);
    const Vec3 found = wind.velocity({0.0, yi, zi}, ti), expected = trilinear(yi, zi, ti);
    EXPECT_LT(norm(found - expected), 2e-5) << yi << ' ' << zi << ' ' << ti;
  }
}

// Values at the grid points themselves, the far corner included, are not touched.
TEST(GriddedWind, GridPointsAreReproduced) {
  const GriddedWind wind = filled(small_spec(false), trilinear);
  EXPECT_EQ(wind.velocity({0.0, 20.0, 80.0}, 4.5).x, wind.grid().at(9, 3, 4, 0));
  EXPECT_EQ(wind.velocity({0.0, -20.0, 20.0}, 0.0).y, wind.grid().at(0, 0, 0, 1));
}

// Taylor: 8 m up-wind at 16 m/s is half a second later, to the last bit.
TEST(GriddedWind, TravelsWithTheMeanSpeed) {
  const GriddedWind wind = filled(small_spec(false), trilinear);
  for (int i = 0; i < 32; ++i) {
    const double t = 0.125 * i;
    EXPECT_EQ(wind.velocity({-8.0, 3.0, 44.0}, t), wind.velocity({0.0, 3.0, 44.0}, t + 0.5));
  }
}

// A periodic field joins its last plane to its first and goes on in both directions.
TEST(GriddedWind, PeriodicInTime) {
  const GriddedWind wind = filled(small_spec(true), [](double, double, double t) {
    return Vec3{t, 0.0, 0.0};
  });
  const auto u = [&](double t) { return wind.velocity({0.0, 0.0, 50.0}, t).x; };
  EXPECT_EQ(wind.duration_s(), 5.0);
  EXPECT_EQ(u(4.5), 4.5);
  EXPECT_EQ(u(4.75), 2.25);
  EXPECT_EQ(u(5.0), 0.0);
  EXPECT_EQ(u(-0.25), 2.25);
  EXPECT_EQ(u(-4.75), 0.25);
  EXPECT_EQ(u(50001.25), 1.25);
  EXPECT_EQ(u(std::nan("")), 0.0);
  EXPECT_EQ(wind.time_end_s(), std::numeric_limits<double>::infinity());
}

// Bounds are stated; beyond them stands the border value, in every direction.
TEST(GriddedWind, BordersHold) {
  const GriddedWind wind = filled(small_spec(false), trilinear);
  const WindExtent e = wind.extent();
  EXPECT_EQ(e.y_min_m, -20.0);
  EXPECT_EQ(e.y_max_m, 20.0);
  EXPECT_EQ(e.z_min_m, 20.0);
  EXPECT_EQ(e.z_max_m, 80.0);
  EXPECT_EQ(e.t_min_s, 0.0);
  EXPECT_EQ(wind.time_end_s(), 4.5);
  EXPECT_EQ(wind.duration_s(), 4.5);
  EXPECT_EQ(wind.velocity({0.0, 1e9, 1e9}, 1e9), wind.velocity({0.0, 20.0, 80.0}, 4.5));
  EXPECT_EQ(wind.velocity({0.0, -1e9, -1e9}, -1e9), wind.velocity({0.0, -20.0, 20.0}, 0.0));
  EXPECT_EQ(wind.velocity({0.0, 0.0, std::nan("")}, 1.0), wind.velocity({0.0, 0.0, 20.0}, 1.0));
}

// The disk is the grid points within the radius, those on the rim among them.
TEST(GriddedWind, DiskPoints) {
  const GriddedWind wind = filled(small_spec(false), trilinear);
  EXPECT_EQ(wind.disk_points(40.0, 20.0).size(), 7u);  // 5 on the axis row, 1 above, 1 below
  EXPECT_EQ(wind.disk_points(40.0, 19.9).size(), 3u);
}

void expect_refused(const GridSpec& spec, const char* text) {
  try {
    VelocityGrid grid(spec);
    FAIL() << text << " was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(text));
  }
}

// A grid that cannot be interpolated is refused by name.
TEST(GriddedWind, RefusesBadGrids) {
  GridSpec spec = small_spec(false);
  spec.ny = 1;
  expect_refused(spec, "ny = 1");
  spec = small_spec(false);
  spec.dt_s = 0.0;
  expect_refused(spec, "dt_s = 0");
  spec = small_spec(false);
  spec.z_bottom_m = -3.0;
  expect_refused(spec, "z_bottom_m = -3");
}

}  // namespace
}  // namespace lac::sim
