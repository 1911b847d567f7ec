// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/flow_shape.hpp"

#include <algorithm>
#include <cmath>

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "flow shape";

void check(const FlowShape& shape, const GridSpec& grid) {
  for (const double scale : shape.fluctuation_scale) {
    require(std::isfinite(scale) && scale >= 0.0, kWhere, "fluctuation_scale", scale,
            "0 or a finite number above");
  }
  require(std::isfinite(shape.shear_exponent), kWhere, "shear_exponent", shape.shear_exponent,
          "a finite number");
  require(shape.shear_exponent >= 0.0 || grid.z_bottom_m > 0.0, kWhere, "shear_exponent",
          shape.shear_exponent, "0 or above for a grid that begins at the ground");
  require(std::isfinite(shape.veer_radpm), kWhere, "veer_radpm", shape.veer_radpm,
          "a finite number");
}

/// Calls f(float* uvw) for all numbers of a height.
template <class F>
void for_each_of_height(VelocityGrid& grid, int iz, const F& f) {
  const GridSpec& g = grid.spec();
  for (int it = 0; it < g.nt; ++it) {
    for (int iy = 0; iy < g.ny; ++iy) f(&grid.at(it, iz, iy, 0));
  }
}

template <class F>
void for_each_of_height(ThinnedGrid& grid, int iz, const F& f) {
  const std::span<const std::uint32_t> points = grid.columns().points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (static_cast<int>(points[i]) / grid.spec().ny != iz) continue;
    const std::span<float> column = grid.column(i);
    for (std::size_t j = 0; j < column.size(); j += 3) f(&column[j]);
  }
}

template <class Grid>
std::array<double, 3> mean_of_height(Grid& grid, int iz) {
  std::array<double, 3> sum{};
  std::size_t count = 0;
  for_each_of_height(grid, iz, [&](const float* v) {
    for (int c = 0; c < 3; ++c) sum[c] += v[c];
    ++count;
  });
  for (double& s : sum) s /= static_cast<double>(std::max<std::size_t>(count, 1));
  return sum;
}

/// value -> scale value + offset, then the turn.
struct HeightMap {
  std::array<double, 3> scale;
  std::array<double, 3> offset;
  double cosine;
  double sine;

  void operator()(float* v) const {
    std::array<double, 3> a;
    for (int c = 0; c < 3; ++c) a[c] = scale[c] * v[c] + offset[c];
    v[0] = static_cast<float>(cosine * a[0] + sine * a[1]);
    v[1] = static_cast<float>(-sine * a[0] + cosine * a[1]);
    v[2] = static_cast<float>(a[2]);
  }
};

HeightMap map_of_height(const FlowShape& shape, const GridSpec& g, int iz,
                        const std::array<double, 3>& mean) {
  const double z_m = g.z_m(iz), turn_rad = shape.veer_radpm * (z_m - g.hub_height_m);
  HeightMap map{shape.fluctuation_scale, {}, std::cos(turn_rad), std::sin(turn_rad)};
  for (int c = 0; c < 3; ++c) map.offset[c] = (1.0 - map.scale[c]) * mean[c];
  map.offset[0] += g.mean_speed_mps * (std::pow(z_m / g.hub_height_m, shape.shear_exponent) - 1.0);
  return map;
}

template <class Grid>
void apply_to(const FlowShape& shape, Grid& grid) {
  check(shape, grid.spec());
  if (shape == FlowShape{}) return;
  for (int iz = 0; iz < grid.spec().nz; ++iz)
    for_each_of_height(grid, iz, map_of_height(shape, grid.spec(), iz, mean_of_height(grid, iz)));
}

}  // namespace

void apply(const FlowShape& shape, VelocityGrid& grid) {
  apply_to(shape, grid);
}

void apply(const FlowShape& shape, ThinnedGrid& grid) {
  apply_to(shape, grid);
}

}  // namespace lac::sim
