// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/sampled_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim_harness/wind/uniform_wind.hpp"
#include "support/error_text.hpp"
#include "tests/sim_harness/wind/wind_bytes.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

// Each number is the field's own at its point and time, and the speed that carries it the field's.
TEST(SampledField, NumbersOfTheField) {
  UniformWindParams params;
  params.history = CoherentGust{10.0, 15.0, 0.6, 1.0};
  params.shear_exponent = 0.2;
  const UniformWind wind(params);
  const GriddedWind grid = sampled_field(wind, {3, 4, 21, 20.0, 25.0, 0.5, 40.0, 90.0, 0.0, false});
  EXPECT_EQ(grid.mean_speed_mps(), 10.0);
  EXPECT_EQ(grid.grid().spec().hub_height_m, 90.0);
  for (const int it : {0, 5, 20}) {
    for (int iz = 0; iz < 4; ++iz) {
      const Vec3 v = wind.velocity({0.0, -20.0, 40.0 + 25.0 * iz}, 0.5 * it);
      EXPECT_NEAR(grid.grid().at(it, iz, 0, 0), v.x, 2e-6);
      EXPECT_NEAR(grid.grid().at(it, iz, 0, 1), v.y, 2e-6);
    }
  }
}

// A grid that leaves the field is refused: which edge, by how much.
TEST(SampledField, RefusesWhatLeavesTheField) {
  const GriddedWind wind = wavy(false);
  const auto error = [&](const GridSpec& spec) {
    return lac::test::error_text([&] { sampled_field(wind, spec); });
  };
  EXPECT_THAT(error({4, 3, 50, 8.0, 9.0, 0.25, 30.0, 39.0, 0.0, false}), HasSubstr("no error"));
  EXPECT_THAT(error({4, 3, 50, 8.1, 9.0, 0.25, 30.0, 39.0, 0.0, false}),
              HasSubstr("right edge [m] = -12.15, expected -12 to 12, where the wind is defined"));
  EXPECT_THAT(error({4, 3, 50, 8.0, 9.1, 0.25, 30.0, 39.0, 0.0, false}),
              HasSubstr("greatest height [m] = 48.2"));
  EXPECT_THAT(error({4, 3, 51, 8.0, 9.0, 0.25, 30.0, 39.0, 0.0, false}),
              HasSubstr("last time [s] = 12.5"));
}

}  // namespace
}  // namespace lac::sim
