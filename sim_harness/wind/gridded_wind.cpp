// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/gridded_wind.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

struct Cell {
  int index;
  float weight;  // of the next point
};

/// A position in steps within [0, n - 1]; outside (and not a number) goes to the border.
inline Cell cell_in(double steps, int n) {
  const double last = n - 1;
  const double inside = steps > 0.0 ? (steps < last ? steps : last) : 0.0;
  const int index = std::min(static_cast<int>(inside), n - 2);
  return {index, static_cast<float>(inside - index)};
}

/// The same on a circle of n steps; what is no time goes to the first.
inline Cell cell_on_circle(double steps, int n, double inverse_n) {
  const double turns = steps * inverse_n;
  if (!(std::abs(turns) < 1e15)) return {0, 0.0F};
  const auto whole = static_cast<double>(static_cast<std::int64_t>(turns));
  const double turn = steps - n * (turns < whole ? whole - 1.0 : whole);
  const double inside = turn > 0.0 ? turn : 0.0;
  const int index = inside < n ? static_cast<int>(inside) : n - 1;
  return {index, static_cast<float>(inside - index)};
}

/// u, v, w and a number that is not used, in one register.
using Point [[gnu::vector_size(16)]] = float;

inline Point load(const float* p) {
  Point point;
  std::memcpy(&point, p, sizeof point);
  return point;
}

inline Point mix(Point a, Point b, float weight_of_b) {
  return a + weight_of_b * (b - a);
}

inline Point bilinear(const float* corner, int row, Cell y, Cell z) {
  return mix(mix(load(corner), load(corner + 3), y.weight),
             mix(load(corner + row), load(corner + row + 3), y.weight), z.weight);
}

}  // namespace

void GridSpec::check() const {
  constexpr auto kWhere = "gridded wind";
  require(ny >= 2, kWhere, "ny", ny, "at least 2");
  require(nz >= 2, kWhere, "nz", nz, "at least 2");
  require(nt >= 2, kWhere, "nt", nt, "at least 2");
  require_positive(kWhere, "dy_m", dy_m);
  require_positive(kWhere, "dz_m", dz_m);
  require_positive(kWhere, "dt_s", dt_s);
  require_positive(kWhere, "hub_height_m", hub_height_m);
  require_positive(kWhere, "mean_speed_mps", mean_speed_mps);
  require(std::isfinite(z_bottom_m) && z_bottom_m >= 0.0, kWhere, "z_bottom_m", z_bottom_m,
          "0 or above (heights are above ground; the grid is too high for its centre)");
}

VelocityGrid::VelocityGrid(const GridSpec& spec) : spec_(spec) {
  spec.check();
  plane_size_ = spec.plane_points() * 3;
  values_.resize(plane_size_ * spec.nt + 1);
}

GriddedWind::GriddedWind(VelocityGrid grid)
    : grid_(std::move(grid)),
      y_min_m_(grid_.spec().y_min_m()),
      inverse_dy_(1.0 / grid_.spec().dy_m),
      inverse_dz_(1.0 / grid_.spec().dz_m),
      inverse_dt_(1.0 / grid_.spec().dt_s),
      inverse_nt_(1.0 / grid_.spec().nt),
      inverse_speed_(1.0 / grid_.spec().mean_speed_mps) {}

Vec3 GriddedWind::velocity(const Vec3& position_I_m, double time_s) const {
  const GridSpec& g = grid_.spec();
  const Cell y = cell_in((position_I_m.y - y_min_m_) * inverse_dy_, g.ny);
  const Cell z = cell_in((position_I_m.z - g.z_bottom_m) * inverse_dz_, g.nz);
  const double steps = (time_s - position_I_m.x * inverse_speed_) * inverse_dt_;
  const Cell t = g.periodic ? cell_on_circle(steps, g.nt, inverse_nt_) : cell_in(steps, g.nt);
  const int next = t.index + 1 == g.nt ? 0 : t.index + 1;

  const int row = 3 * g.ny;
  const std::size_t corner = static_cast<std::size_t>(z.index) * row + 3 * y.index;
  const Point a = bilinear(grid_.plane(t.index).data() + corner, row, y, z);
  const Point b = bilinear(grid_.plane(next).data() + corner, row, y, z);
  const Point wind = mix(a, b, t.weight);
  return {wind[0], wind[1], wind[2]};
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

double GriddedWind::duration_s() const {
  const GridSpec& g = grid_.spec();
  return (g.periodic ? g.nt : g.nt - 1) * g.dt_s;
}

}  // namespace lac::sim
