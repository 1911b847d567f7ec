// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/turbulence_case.hpp"

#include "sim_harness/run/uniform_wind_case.hpp"

namespace lac::sim {

std::unique_ptr<WindField> shaped_field(GriddedWind wind, const FlowShape& shape) {
  VelocityGrid grid = std::move(wind).take_grid();
  apply(shape, grid);
  return std::make_unique<GriddedWind>(std::move(grid));
}

double read_sigma_u(YamlReader& in, double mean_speed_mps) {
  const IecClass iec = read_iec_class(in);
  const bool extreme = in.choice("turbulence_model", 0, {"normal", "extreme"}) == 1;
  const double standard_mps =
      extreme ? etm_sigma_mps(iec, mean_speed_mps) : ntm_sigma_mps(iec.turbulence, mean_speed_mps);
  return in.number("sigma_u_mps", standard_mps, Range::positive());
}

}  // namespace lac::sim
