// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/gridded_wind.hpp"

#include <limits>

namespace lac::sim {

GriddedWind::GriddedWind(VelocityGrid grid) : grid_(std::move(grid)), locator_(grid_.spec()) {}

Vec3 GriddedWind::velocity(const Vec3& position_I_m, double time_s) const {
  const GridStencil s = locator_.at(position_I_m, time_s);
  const std::size_t row = 3 * static_cast<std::size_t>(grid_.spec().ny);
  const std::size_t corner = s.z.index * row + 3 * static_cast<std::size_t>(s.y.index);
  const auto corners = [&](int it) -> GridCorners {
    const float* first = grid_.plane(it).data() + corner;
    return {first, first + 3, first + row, first + row + 3};
  };
  return interpolate(s, corners(s.t.index), corners(s.next_t));
}

WindExtent GriddedWind::extent() const {
  const GridSpec& g = grid_.spec();
  WindExtent extent{g.y_m(0), g.y_m(g.ny - 1), g.z_m(0), g.z_m(g.nz - 1)};
  if (!g.periodic) {
    extent.t_min_s = 0.0;
    extent.t_max_s = duration_s();
  }
  return extent;
}

std::vector<DiskPoint> GriddedWind::disk_points(double hub_height_m, double radius_m) const {
  const GridSpec& g = grid_.spec();
  std::vector<DiskPoint> points;
  for (int iz = 0; iz < g.nz; ++iz) {
    for (int iy = 0; iy < g.ny; ++iy) {
      const DiskPoint p{g.y_m(iy), g.z_m(iz)};
      if (p.inside(hub_height_m, radius_m)) points.push_back(p);
    }
  }
  return points;
}

double GriddedWind::period_s() const {
  return grid_.spec().periodic ? duration_s() : std::numeric_limits<double>::infinity();
}

double GriddedWind::duration_s() const {
  const GridSpec& g = grid_.spec();
  return (g.periodic ? g.nt : g.nt - 1) * g.dt_s;
}

}  // namespace lac::sim
