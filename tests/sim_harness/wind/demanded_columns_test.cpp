// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/demanded_columns.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace lac::sim {
namespace {

/// y from -20 to 20 m, z from 70 to 110 m, points 10 m apart.
GridSpec grid() {
  return {5, 5, 4, 10.0, 10.0, 1.0, 70.0, 90.0, 16.0, true};
}

std::vector<std::uint32_t> points(const GridColumns& columns) {
  return {columns.points().begin(), columns.points().end()};
}

std::vector<GridColumns> demanded(const Vec3& point, double margin_m) {
  const WindDemand demand{{}, {point}, margin_m};
  return demanded_columns(PlaneLayout({50.0, 100.0}), grid(), &demand);
}

// One point without margin: the four corners of its cell in the nearest plane, nothing elsewhere.
TEST(DemandedColumns, CornersOfTheCell) {
  const auto columns = demanded({-60.0, 3.0, 76.0}, 0.0);
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(points(columns[0]), (std::vector<std::uint32_t>{2, 3, 7, 8}));
  EXPECT_EQ(columns[0].of_point(7), 2);
  EXPECT_EQ(columns[0].of_point(6), GridColumns::kNone);
  EXPECT_EQ(columns[1].count(), 0U);
}

// With a margin: all cells it reaches, in the planes it reaches; clamped at the edges of the grid.
TEST(DemandedColumns, Margin) {
  const auto columns = demanded({-73.0, 3.0, 72.0}, 4.0);
  for (const GridColumns& plane : columns)
    EXPECT_EQ(points(plane), (std::vector<std::uint32_t>{1, 2, 3, 6, 7, 8}));
  EXPECT_EQ(demanded({-70.0, 3.0, 72.0}, 4.0)[1].count(), 0U);
}

// Points at the rotor keep nothing up-wind; without a demand everything is kept.
TEST(DemandedColumns, NothingAndAll) {
  EXPECT_EQ(demanded({-20.0, 3.0, 76.0}, 1.0)[0].count(), 0U);
  for (const GridColumns& plane : demanded_columns(PlaneLayout({50.0}), grid(), nullptr))
    EXPECT_EQ(plane.count(), 25U);
}

// A margin that is none.
TEST(DemandedColumns, RefusesBadMargin) {
  EXPECT_THROW(demanded({-60.0, 3.0, 76.0}, -1.0), Error);
}

}  // namespace
}  // namespace lac::sim
