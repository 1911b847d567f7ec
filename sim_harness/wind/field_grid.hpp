// SPDX-License-Identifier: Apache-2.0
// What the parameters of every generated field have in common: grid, period, mean profile.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "sim_harness/wind/parameter_check.hpp"
#include "sim_harness/wind/velocity_grid.hpp"

namespace lac::sim {

/// Throws lac::Error on numbers out of range; where: who asks.
template <class FieldParams>
void check_field_grid(std::string_view where, const FieldParams& p) {
  require(p.ny >= 2, where, "ny", p.ny, "at least 2");
  require(p.nz >= 2, where, "nz", p.nz, "at least 2");
  require_positive(where, "width_m", p.width_m);
  require_positive(where, "height_m", p.height_m);
  require_positive(where, "dt_s", p.dt_s);
  require_positive(where, "duration_s", p.duration_s);
  require_positive(where, "mean_speed_mps", p.mean_speed_mps);
  const double steps = p.duration_s / p.dt_s;
  require(std::abs(steps - std::round(steps)) < 1e-6 * steps, where, "duration_s", p.duration_s,
          "a whole number of steps dt_s");
  require(steps > 7.5 && steps < 1e8, where, "duration_s / dt_s", steps, "from 8 to 1e8");
  require(std::isfinite(p.shear_exponent) && p.shear_exponent >= 0.0, where, "shear_exponent",
          p.shear_exponent, "0 or a finite number above");
  require(p.threads >= 1, where, "threads", p.threads, "at least 1");
}

/// Of checked parameters; periodic. Throws lac::Error as GridSpec::check().
template <class FieldParams>
GridSpec field_grid(const FieldParams& p) {
  GridSpec spec;
  spec.ny = p.ny;
  spec.nz = p.nz;
  spec.nt = static_cast<int>(std::lround(p.duration_s / p.dt_s));
  spec.dy_m = p.width_m / (p.ny - 1);
  spec.dz_m = p.height_m / (p.nz - 1);
  spec.dt_s = p.dt_s;
  spec.z_bottom_m = p.hub_height_m - 0.5 * p.height_m;
  spec.hub_height_m = p.hub_height_m;
  spec.mean_speed_mps = p.mean_speed_mps;
  spec.periodic = true;
  spec.check();
  return spec;
}

/// U (z / z_hub)^exponent at each height of the grid [m/s].
inline std::vector<float> mean_profile(const GridSpec& grid, double shear_exponent) {
  std::vector<float> mean;
  for (int iz = 0; iz < grid.nz; ++iz) {
    const double profile = std::pow(grid.z_m(iz) / grid.hub_height_m, shear_exponent);
    mean.push_back(static_cast<float>(grid.mean_speed_mps * profile));
  }
  return mean;
}

}  // namespace lac::sim
