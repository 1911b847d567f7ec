// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>

#include "sim_harness/cli/wind_input.hpp"

namespace lac::sim {

/// How a wind is put on a grid, or into rows, that has none of its own. 0: not given.
struct WindSamplingOptions {
  int points_across = 0;
  int points_up = 0;
  double width_m = 0.0;
  double height_m = 0.0;  // centred on the hub
  double duration_s = 600.0;
  double time_step_s = 0.05;
};

/// Writes a wind in the format of the ending: .bts; .bin, .turb or .u (a box); .hh or .dat
/// (uniform); .wnd: Bladed's, or uniform if the wind is and no grid is asked for. A wind on a grid
/// keeps it; others are sampled at the rotor plane. Says on `out` what was written, and of a box
/// what its readers must be told. Throws lac::Error.
void write_wind(const std::filesystem::path& file, const LoadedWind& wind,
                const WindSamplingOptions& sampling, BoxOrder box_order, std::ostream& out);

/// The planes of evolving wind one by one, each in a file of its own: FILE with _0m, _50m, ...
/// before its ending. Throws lac::Error if the wind does not evolve or the format has no grid.
void write_planes(const std::filesystem::path& file, const WindCase& wind, BoxOrder box_order,
                  std::ostream& out);

}  // namespace lac::sim
