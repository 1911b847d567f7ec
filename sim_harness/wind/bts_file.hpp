// SPDX-License-Identifier: Apache-2.0
// TurbSim full-field files (.bts), ids 7 and 8, little-endian:
//   int16 id (8: periodic); int32 nz, ny, n_tower, nt; float32 dz, dy, dt, u_hub, z_hub, z_bottom;
//   float32 scale, offset for u, v, w; int32 length, description; then per time step int16
//   [z][y][u, v, w] and n_tower points; velocity = (i - offset) / scale. y rises from
//   -(ny - 1)/2 dy to the left looking down-wind.
#pragma once

#include <filesystem>
#include <string_view>

#include "sim_harness/wind/gridded_wind.hpp"

namespace lac::sim {

/// Reads a field; tower points are passed over. Time 0 is the first step of the file at the rotor
/// plane. (InflowWind starts a file that is not periodic half a grid width further on: its time 0
/// is (ny - 1)/2 dy / U here.)
/// Throws lac::Error with file, offset, found and expected if the file cannot be read, is of
/// another kind, has sizes that are not plausible, or is shorter or longer than they say.
GriddedWind read_bts(const std::filesystem::path& file);

/// Writes a field, each component with the full int16 range over its own values: the error is at
/// most (max - min) / 65535 / 2 (and float32 rounding). Throws lac::Error if it cannot be written.
void write_bts(const std::filesystem::path& file, const GriddedWind& wind,
               std::string_view description);

}  // namespace lac::sim
