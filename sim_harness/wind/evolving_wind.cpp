// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/evolving_wind.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "evolving wind";

/// Columns of the four points about a place, [2 z + y]; kNone where they were not kept.
std::array<std::int32_t, 4> corner_columns(const ThinnedGrid& grid, const GridCell& y,
                                           const GridCell& z) {
  const auto ny = static_cast<std::size_t>(grid.spec().ny);
  const std::size_t first = z.index * ny + static_cast<std::size_t>(y.index);
  const GridColumns& columns = grid.columns();
  return {columns.of_point(first), columns.of_point(first + 1), columns.of_point(first + ny),
          columns.of_point(first + ny + 1)};
}

bool all_kept(const std::array<std::int32_t, 4>& columns) {
  return std::ranges::min(columns) != GridColumns::kNone;
}

[[noreturn]] void throw_not_kept(const Vec3& p) {
  std::ostringstream text;
  text << kWhere << ": asked for the wind at x " << p.x << ", y " << p.y << ", z " << p.z
       << " m, which was not kept: it is farther than the margin from every point of the demand";
  throw Error(text.str());
}

}  // namespace

EvolvingWind::EvolvingWind(EvolvingGrids grids)
    : layout_(std::move(grids.layout)),
      rotor_(std::move(grids.rotor)),
      upwind_(std::move(grids.upwind)),
      locator_(rotor_.grid().spec()) {
  require(upwind_.size() + 1 == layout_.size(), kWhere, "number of grids up-wind",
          static_cast<double>(upwind_.size()), "one per plane of the layout");
  for (std::size_t i = 0; i < upwind_.size(); ++i) {
    require(upwind_[i].spec() == rotor_.grid().spec(), kWhere,
            "number of the plane with another grid", static_cast<double>(i + 1),
            "all planes on the grid of the rotor plane");
  }
}

Vec3 EvolvingWind::velocity(const Vec3& position_I_m, double time_s) const {
  const std::size_t plane = layout_.nearest(-position_I_m.x);
  if (plane == 0) return rotor_.velocity(position_I_m, time_s);
  const ThinnedGrid& grid = upwind_[plane - 1];
  const GridStencil s = locator_.at(position_I_m, time_s);
  const std::array<std::int32_t, 4> columns = corner_columns(grid, s.y, s.z);
  if (!all_kept(columns)) throw_not_kept(position_I_m);
  const auto corners = [&](int it) {
    GridCorners c;
    for (std::size_t i = 0; i < c.size(); ++i)
      c[i] = grid.column(columns[i]).data() + 3 * static_cast<std::size_t>(it);
    return c;
  };
  return interpolate(s, corners(s.t.index), corners(s.next_t));
}

bool EvolvingWind::holds(const Vec3& position_I_m) const {
  const std::size_t plane = layout_.nearest(-position_I_m.x);
  return plane == 0 || all_kept(corner_columns(upwind_[plane - 1], locator_.y(position_I_m.y),
                                               locator_.z(position_I_m.z)));
}

}  // namespace lac::sim
