// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_harness/wind/gridded_wind.hpp"

namespace lac::sim {

/// Any field as numbers on a grid at the rotor plane (x = 0), at times 0, dt, ... (nt - 1) dt: for
/// files, which know no other place. mean_speed_mps of the grid is set to that of the field.
/// Throws lac::Error if the grid leaves the field.
GriddedWind sampled_field(const WindField& field, GridSpec grid);

}  // namespace lac::sim
