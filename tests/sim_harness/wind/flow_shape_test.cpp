// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/flow_shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

/// Two points across, heights 45, 90 and 135 m (hub 90 m), 4 steps; U = 10 m/s. u = 10 +- 1 in
/// turn over the steps, v = +- 0.5 between the points, w = 0.2.
VelocityGrid field() {
  VelocityGrid grid({2, 3, 4, 10.0, 45.0, 1.0, 45.0, 90.0, 10.0, true});
  for (int it = 0; it < 4; ++it) {
    for (int k = 0; k < 6; ++k) {
      float* v = &grid.at(it, k / 2, k % 2, 0);
      v[0] = it % 2 == 0 ? 11.0F : 9.0F;
      v[1] = k % 2 == 0 ? 0.5F : -0.5F;
      v[2] = 0.2F;
    }
  }
  return grid;
}

// Nothing asked for, nothing done, to the last bit.
TEST(FlowShape, DefaultChangesNothing) {
  VelocityGrid grid = field();
  apply({}, grid);
  for (int it = 0; it < 4; ++it) {
    for (int i = 0; i < 18; ++i) EXPECT_EQ(grid.plane(it)[i], field().plane(it)[i]);
  }
}

// Fluctuations about the mean of the height are scaled, the mean is not: u 10 +- 2, v +- 0.25, and
// w, all mean, stays.
TEST(FlowShape, ScalesFluctuations) {
  VelocityGrid grid = field();
  apply({.fluctuation_scale = {2.0, 0.5, 3.0}}, grid);
  EXPECT_NEAR(grid.at(0, 1, 0, 0), 12.0, 1e-5);
  EXPECT_NEAR(grid.at(1, 1, 0, 0), 8.0, 1e-5);
  EXPECT_NEAR(grid.at(0, 2, 1, 1), -0.25, 1e-6);
  EXPECT_NEAR(grid.at(3, 0, 1, 2), 0.2, 1e-6);
}

// A thinned field becomes what the whole one does, here with one column, of v 0.5 on average, of
// the upper height: v is all mean there and stays; u, shear and veer are as in the whole field.
TEST(FlowShape, ThinnedField) {
  std::vector<bool> kept(6, true);
  kept[5] = false;
  const FlowShape shape{.fluctuation_scale = {2.0, 0.5, 3.0}, .shear_exponent = 0.2};
  VelocityGrid whole = field();
  ThinnedGrid thinned(whole, GridColumns(kept));
  apply(shape, whole);
  apply(shape, thinned);
  for (int point = 0; point < 5; ++point) {
    for (int it = 0; it < 4; ++it) {
      const float* v = &thinned.column(point)[3 * it];
      EXPECT_NEAR(v[0], whole.at(it, point / 2, point % 2, 0), 1e-5);
      EXPECT_NEAR(v[1], point == 4 ? 0.5 : whole.at(it, point / 2, point % 2, 1), 1e-6);
    }
  }
  VelocityGrid veered = field();
  ThinnedGrid veered_too(veered, GridColumns(kept));
  apply({.veer_radpm = 0.01}, veered);
  apply({.veer_radpm = 0.01}, veered_too);
  EXPECT_EQ(veered_too.column(4)[3], veered.at(1, 2, 0, 0));
}

// The power law by hand with exponent 0.2: 10 (0.5^0.2 - 1) = -1.29449 and 10 (1.5^0.2 - 1) =
// 0.84472 m/s at the borders, nothing at the hub.
TEST(FlowShape, AddsShear) {
  VelocityGrid grid = field();
  apply({.shear_exponent = 0.2}, grid);
  EXPECT_NEAR(grid.at(0, 0, 0, 0), 11.0 - 1.294494, 1e-5);
  EXPECT_NEAR(grid.at(1, 1, 0, 0), 9.0, 1e-5);
  EXPECT_NEAR(grid.at(0, 2, 1, 0), 11.0 + 0.844718, 1e-5);
}

// Veer of 0.2 deg/m is 9 deg at 45 m from the hub, clockwise with height: above, the wind blows to
// the right, below to the left; (11, 0.5) by hand.
TEST(FlowShape, TurnsWithHeight) {
  VelocityGrid grid = field();
  apply({.veer_radpm = rad_from_deg(0.2)}, grid);
  const double c = 0.987688, s = 0.156434;
  EXPECT_NEAR(grid.at(0, 2, 0, 0), c * 11.0 + s * 0.5, 1e-5);
  EXPECT_NEAR(grid.at(0, 2, 0, 1), -s * 11.0 + c * 0.5, 1e-5);
  EXPECT_NEAR(grid.at(0, 0, 0, 1), s * 11.0 + c * 0.5, 1e-5);
  EXPECT_NEAR(grid.at(0, 1, 0, 1), 0.5, 1e-6);
  EXPECT_NEAR(grid.at(0, 2, 0, 2), 0.2, 1e-6);
}

// All at once: scaled, then sheared, then turned.
TEST(FlowShape, InThisOrder) {
  VelocityGrid grid = field();
  apply({{2.0, 2.0, 1.0}, 0.2, rad_from_deg(0.2)}, grid);
  const double u = 12.0 + 0.844718, v = -1.0, c = 0.987688, s = 0.156434;
  EXPECT_NEAR(grid.at(2, 2, 1, 0), c * u + s * v, 1e-5);
  EXPECT_NEAR(grid.at(2, 2, 1, 1), -s * u + c * v, 1e-5);
}

// What cannot be is refused by name.
TEST(FlowShape, Refuses) {
  const auto error = [](const FlowShape& shape, double z_bottom_m) {
    return test::error_text([&] {
      VelocityGrid grid({2, 3, 4, 10.0, 45.0, 1.0, z_bottom_m, 90.0, 10.0, true});
      apply(shape, grid);
    });
  };
  EXPECT_THAT(error({.fluctuation_scale = {1.0, -0.1, 1.0}}, 45.0), HasSubstr("scale = -0.1"));
  EXPECT_THAT(error({.shear_exponent = -0.1}, 0.0), HasSubstr("shear_exponent = -0.1"));
  EXPECT_THAT(error({.shear_exponent = -0.1}, 45.0), HasSubstr("no error"));
  EXPECT_THAT(error({.veer_radpm = NAN}, 45.0), HasSubstr("veer_radpm = nan"));
}

}  // namespace
}  // namespace lac::sim
