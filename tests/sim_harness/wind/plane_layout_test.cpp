// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/plane_layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

// The rotor plane is number 0; a point belongs to the nearest plane, half-way to the one nearer to
// the rotor; the outer planes hold beyond them.
TEST(PlaneLayout, NearestPlane) {
  const PlaneLayout layout({50.0, 80.0});
  ASSERT_EQ(layout.size(), 3U);
  EXPECT_EQ(layout.distance_m(0), 0.0);
  EXPECT_EQ(layout.last_m(), 80.0);
  EXPECT_EQ(layout.nearest(-40.0), 0U);
  EXPECT_EQ(layout.nearest(25.0), 0U);
  EXPECT_EQ(layout.nearest(25.1), 1U);
  EXPECT_EQ(layout.nearest(65.0), 1U);
  EXPECT_EQ(layout.nearest(65.1), 2U);
  EXPECT_EQ(layout.nearest(500.0), 2U);
}

// Half a distance of planes beyond the last one; with one plane up-wind it counts from the rotor.
TEST(PlaneLayout, Reach) {
  EXPECT_EQ(PlaneLayout({50.0, 80.0}).reach_m(), 95.0);
  EXPECT_EQ(PlaneLayout({50.0}).reach_m(), 75.0);
}

// Distances must be there, be above 0 and rise.
TEST(PlaneLayout, RefusesDistancesThatDoNotRise) {
  const auto error = [](std::vector<double> planes_m) {
    return test::error_text([&] { PlaneLayout layout(planes_m); });
  };
  EXPECT_THAT(error({}), testing::HasSubstr("number of planes up-wind = 0"));
  EXPECT_THAT(error({0.0, 10.0}), testing::HasSubstr("distance of a plane [m] = 0"));
  EXPECT_THAT(error({10.0, 10.0}), testing::HasSubstr("distance of a plane [m] = 10"));
  EXPECT_THAT(error({10.0, 1.0 / 0.0}), testing::HasSubstr("distance of a plane [m] = inf"));
}

// A plane for each gate, at the mean of its distances over the beams, in rising order; gates at one
// distance share theirs, and one that is far apart in two groups of beams has two.
TEST(PlaneLayout, PlanesAtGates) {
  WindDemand demand;
  demand.gates = {{1, 1, {-100.0, 0.0, 90.0}}, {2, 1, {-104.0, 0.0, 90.0}},
                  {1, 2, {-50.0, 0.0, 90.0}},  {2, 2, {-51.0, 0.0, 90.0}},
                  {1, 3, {-50.5, 0.0, 90.0}},  {1, 4, {-160.0, 0.0, 90.0}}};
  EXPECT_EQ(planes_at_gates(demand), (std::vector{50.5, 102.0, 160.0}));
  demand.gates = {{1, 1, {-100.0, 0.0, 90.0}},
                  {2, 1, {-60.0, 0.0, 90.0}},
                  {3, 1, {-108.0, 0.0, 90.0}},
                  {4, 1, {-64.0, 0.0, 90.0}}};
  EXPECT_EQ(planes_at_gates(demand), (std::vector{62.0, 104.0}));
  EXPECT_THROW(planes_at_gates({}), Error);
  demand.gates = {{1, 1, {3.0, 0.0, 90.0}}};
  EXPECT_THROW(planes_at_gates(demand), Error);
}

}  // namespace
}  // namespace lac::sim
