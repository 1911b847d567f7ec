// SPDX-License-Identifier: Apache-2.0
// Bladed-style full-field files (.wnd with a .sum of the same name), little-endian:
//   int16 -99, 4; int32 3; float32 latitude, roughness length, height of the grid's centre,
//   TI of u, v, w [%]; float32 dz, dy, dx; int32 nt/2; float32 U, three length scales;
//   int32 0, seed, nz, ny, 0, 0, 0, 0, 0, 0; then per time step int16 [z][y][u, v, w].
// u = U + i U TI_u / 1e5, v = -+ i U TI_v / 1e5, w = i U TI_w / 1e5, dt = dx / U. y rises from
// -(ny - 1)/2 dy to the left looking down-wind unless the summary says clockwise; v is positive to
// the right (minus sign) if the summary says left-hand rule.
#pragma once

#include <filesystem>

#include "sim_harness/wind/gridded_wind.hpp"

namespace lac::sim {

/// Reads a field and the summary beside it. Time 0 is the first step at the rotor plane (InflowWind
/// starts one that is not periodic half a grid width further on). One step more than the header
/// says is taken too: nt/2 cannot hold an odd number.
/// Throws lac::Error with file, place, found and expected if a file cannot be read, is of another
/// kind, has sizes that are not plausible, or if the two do not belong together.
GriddedWind read_bladed(const std::filesystem::path& wnd_file);

/// Writes both files, with the left-hand rule as TurbSim does. The scale of a component is its
/// standard deviation, or more if the integers could not hold its values: the error is at most
/// max(sigma, greatest deviation / 32.7, 0.01 m/s) / 2000 (and float32 rounding of U and dx).
/// Throws lac::Error if a file cannot be written.
void write_bladed(const std::filesystem::path& wnd_file, const GriddedWind& wind);

}  // namespace lac::sim
