// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/evolving_grids.hpp"

#include "sim_harness/wind/time_transform.hpp"

namespace lac::sim {

EvolvingGrids empty_grids(const PlaneLayout& layout, const GridSpec& grid,
                          const WindDemand* demand) {
  EvolvingGrids grids{layout, VelocityGrid(grid), {}};
  for (GridColumns& columns : demanded_columns(layout, grid, demand))
    grids.upwind.emplace_back(grid, std::move(columns));
  return grids;
}

std::size_t planes_to_draw(const EvolvingGrids& grids) {
  std::size_t planes = grids.layout.size();
  while (planes > 1 && grids.upwind[planes - 2].columns().count() == 0) --planes;
  return planes;
}

void amplitudes_to_series(EvolvingGrids& grids, std::span<const float> mean_u_mps, int threads) {
  amplitudes_to_series(grids.rotor, mean_u_mps, threads);
  for (ThinnedGrid& grid : grids.upwind) amplitudes_to_series(grid, mean_u_mps, threads);
}

}  // namespace lac::sim
