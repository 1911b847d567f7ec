// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/velocity_grid.hpp"

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {

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

}  // namespace lac::sim
