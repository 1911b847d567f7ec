// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/demanded_columns.hpp"

#include "sim_harness/wind/grid_interpolation.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr double kRounding_m = 1e-6;  // of positions computed in another order

struct IndexRange {
  int first;
  int last;  // included
};

using Marks = std::vector<std::vector<bool>>;  // [plane][point]

void mark(const IndexRange& planes, const IndexRange& y, const IndexRange& z, int ny,
          Marks& marks) {
  for (int plane = planes.first; plane <= planes.last; ++plane) {
    for (int iz = z.first; iz <= z.last; ++iz) {
      for (int iy = y.first; iy <= y.last; ++iy)
        marks[plane][static_cast<std::size_t>(iz) * ny + iy] = true;
    }
  }
}

void mark_demand(const PlaneLayout& layout, const GridSpec& grid, const WindDemand& demand,
                 Marks& marks) {
  require(std::isfinite(demand.margin_m) && demand.margin_m >= 0.0, "wind demand", "margin_m",
          demand.margin_m, "0 or a finite number above");
  const GridLocator locator(grid);
  const double margin_m = demand.margin_m + kRounding_m;
  for (const Vec3& p : demand.points_I_m) {
    const IndexRange planes{static_cast<int>(layout.nearest(-p.x - margin_m)),
                            static_cast<int>(layout.nearest(-p.x + margin_m))};
    const IndexRange y{locator.y(p.y - margin_m).index, locator.y(p.y + margin_m).index + 1};
    const IndexRange z{locator.z(p.z - margin_m).index, locator.z(p.z + margin_m).index + 1};
    mark(planes, y, z, grid.ny, marks);
  }
}

}  // namespace

std::vector<GridColumns> demanded_columns(const PlaneLayout& layout, const GridSpec& grid,
                                          const WindDemand* demand) {
  Marks marks(layout.size(), std::vector<bool>(grid.plane_points(), demand == nullptr));
  if (demand != nullptr) mark_demand(layout, grid, *demand, marks);
  std::vector<GridColumns> columns;
  for (std::size_t plane = 1; plane < layout.size(); ++plane) columns.emplace_back(marks[plane]);
  return columns;
}

}  // namespace lac::sim
