// SPDX-License-Identifier: Apache-2.0
// Uniform wind files (.hh, .wnd, .dat; WindType 2 of InflowWind): text, one time a row,
//   time [s], speed [m/s], direction [deg], vertical speed [m/s], horizontal linear shear [-],
//   vertical power-law exponent [-], vertical linear shear [-], gust [m/s], upflow [deg]
// separated by blanks, tabs or commas; the ninth number may be missing in all rows (0). Rows
// beginning with "!" or "#" are comments. What the numbers do: UniformState.
#pragma once

#include <filesystem>
#include <string>

#include "sim_harness/wind/uniform_history.hpp"

namespace lac::sim {

/// Directions are continued the shorter way round: a row never turns by more than 180 deg from the
/// one before (as InflowWind does). Throws lac::Error with file, line, found and expected.
UniformTable read_uniform_file(const std::filesystem::path& file);

/// Writes nine columns, directions and upflow in degrees; description becomes a comment. Throws
/// lac::Error if it cannot be written.
void write_uniform_file(const std::filesystem::path& file, const UniformTable& table,
                        const std::string& description);

}  // namespace lac::sim
