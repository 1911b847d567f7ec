// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/flow_shape.hpp"

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

std::array<double, 3> mean_of_height(const VelocityGrid& grid, int iz) {
  const GridSpec& g = grid.spec();
  std::array<double, 3> sum{};
  for (int it = 0; it < g.nt; ++it) {
    for (int iy = 0; iy < g.ny; ++iy) {
      for (int c = 0; c < 3; ++c) sum[c] += grid.at(it, iz, iy, c);
    }
  }
  for (double& s : sum) s /= static_cast<double>(g.nt) * g.ny;
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

HeightMap map_of_height(const FlowShape& shape, const VelocityGrid& grid, int iz) {
  const GridSpec& g = grid.spec();
  const double z_m = g.z_m(iz), turn_rad = shape.veer_radpm * (z_m - g.hub_height_m);
  HeightMap map{shape.fluctuation_scale, {}, std::cos(turn_rad), std::sin(turn_rad)};
  const std::array<double, 3> mean = mean_of_height(grid, iz);
  for (int c = 0; c < 3; ++c) map.offset[c] = (1.0 - map.scale[c]) * mean[c];
  map.offset[0] += g.mean_speed_mps * (std::pow(z_m / g.hub_height_m, shape.shear_exponent) - 1.0);
  return map;
}

}  // namespace

void apply(const FlowShape& shape, VelocityGrid& grid) {
  const GridSpec& g = grid.spec();
  check(shape, g);
  if (shape == FlowShape{}) return;
  for (int iz = 0; iz < g.nz; ++iz) {
    const HeightMap map = map_of_height(shape, grid, iz);
    for (int it = 0; it < g.nt; ++it) {
      for (int iy = 0; iy < g.ny; ++iy) map(&grid.at(it, iz, iy, 0));
    }
  }
}

}  // namespace lac::sim
