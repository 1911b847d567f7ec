// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/sampled_field.hpp"

#include <sstream>

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

void require_within(double found, double low, double high, double rounding, const char* name) {
  std::ostringstream expected;
  expected << low << " to " << high << ", where the wind is defined";
  require(found >= low - rounding && found <= high + rounding, "grid for this wind", name, found,
          expected.str());
}

void check_inside(const GridSpec& g, const WindExtent& e) {
  const double edge_m = 1e-6 * (g.dy_m + g.dz_m), edge_s = 1e-6 * g.dt_s;
  require_within(g.y_m(0), e.y_min_m, e.y_max_m, edge_m, "right edge [m]");
  require_within(g.y_m(g.ny - 1), e.y_min_m, e.y_max_m, edge_m, "left edge [m]");
  require_within(g.z_m(0), e.z_min_m, e.z_max_m, edge_m, "lowest height [m]");
  require_within(g.z_m(g.nz - 1), e.z_min_m, e.z_max_m, edge_m, "greatest height [m]");
  require_within(0.0, e.t_min_s, e.t_max_s, edge_s, "first time [s]");
  require_within((g.nt - 1) * g.dt_s, e.t_min_s, e.t_max_s, edge_s, "last time [s]");
}

}  // namespace

GriddedWind sampled_field(const WindField& field, GridSpec g) {
  g.mean_speed_mps = field.mean_speed_mps();
  VelocityGrid grid(g);
  check_inside(g, field.extent());
  for (int it = 0; it < g.nt; ++it) {
    for (int iz = 0; iz < g.nz; ++iz) {
      for (int iy = 0; iy < g.ny; ++iy) {
        const Vec3 v = field.velocity({0.0, g.y_m(iy), g.z_m(iz)}, it * g.dt_s);
        grid.at(it, iz, iy, 0) = static_cast<float>(v.x);
        grid.at(it, iz, iy, 1) = static_cast<float>(v.y);
        grid.at(it, iz, iy, 2) = static_cast<float>(v.z);
      }
    }
  }
  return GriddedWind(std::move(grid));
}

}  // namespace lac::sim
