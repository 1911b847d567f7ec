// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "sim_harness/wind/demanded_columns.hpp"

namespace lac::sim {

/// The numbers of evolving wind while they are being filled: the wind as it is in the rotor plane,
/// and as it is while it is up-wind in each other plane of the layout, of which some columns are
/// kept. The time axis of each is that of arrival at the rotor, as in every gridded field.
struct EvolvingGrids {
  PlaneLayout layout;
  VelocityGrid rotor;
  std::vector<ThinnedGrid> upwind;  // of planes 1, 2, ...
};

/// All zero, with room for what is demanded (nullptr: all).
EvolvingGrids empty_grids(const PlaneLayout& layout, const GridSpec& grid,
                          const WindDemand* demand);

/// Number of planes, the rotor's included, up to the last one of which something is kept.
std::size_t planes_to_draw(const EvolvingGrids& grids);

/// As in time_transform.hpp, all planes.
void amplitudes_to_series(EvolvingGrids& grids, std::span<const float> mean_u_mps, int threads);

}  // namespace lac::sim
