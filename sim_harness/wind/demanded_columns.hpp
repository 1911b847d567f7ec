// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/wind/plane_layout.hpp"
#include "sim_harness/wind/thinned_grid.hpp"

namespace lac::sim {

/// What of the planes up-wind a demand reaches, rotor plane not included: for each the corners of
/// all grid cells within the margin of a point, in y and z, if the plane is the nearest to the
/// point within the margin along x. nullptr: all of it.
std::vector<GridColumns> demanded_columns(const PlaneLayout& layout, const GridSpec& grid,
                                          const WindDemand* demand);

}  // namespace lac::sim
