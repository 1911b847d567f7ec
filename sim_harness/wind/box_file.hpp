// SPDX-License-Identifier: Apache-2.0
// Turbulence boxes of HAWC2 and Mann generators: three headerless files of float32, u, v and w
// [m/s], x slowest, then y, z fastest and upwards. Mean speed, sizes and the sense of x and y are
// not in the files; the caller knows them.
#pragma once

#include <array>
#include <filesystem>

#include "sim_harness/wind/gridded_wind.hpp"

namespace lac::sim {

/// How the numbers of a box lie in frame I. The default is what InflowWind (OpenFAST 5) does: the
/// first plane meets the rotor first, as in HAWC2, rows begin on the left (y > 0, looking
/// down-wind) and run to the right; v is not turned round with them. In the frame of Mann's tensor
/// x points down-wind and y to the left: the last plane meets the rotor first and rows begin on the
/// right.
struct BoxOrder {
  bool first_plane_first = true;
  bool rows_from_left = true;

  static constexpr BoxOrder mann_frame() { return {false, false}; }
};

using BoxFiles = std::array<std::filesystem::path, 3>;  // u, v, w

/// The three files of a box. From the file of u where its ending is ".u" or its name ends in u
/// before the ending ("a-u.bin", "a_u.bin", "au.turb", "a.u"): that letter becomes v and w. From
/// any other name by adding "-u", "-v", "-w" before the ending, as TurbSim names them.
BoxFiles box_files(const std::filesystem::path& name);

/// Reads a box as one field: spec says how many points (nt along x, dt = dx / U) and where they
/// are; its mean speed U is added to u, without a profile.
/// Throws lac::Error with file, offset, found and expected if a file cannot be read, has not
/// exactly 4 nt ny nz bytes, or holds a number that is no wind speed (not finite, or above 300 m/s:
/// not float32, or another byte order).
GriddedWind read_box(const BoxFiles& files, const GridSpec& spec, BoxOrder order = {});

/// Writes a field less its mean speed U; a profile stays in the numbers. Throws lac::Error if a
/// file cannot be written.
void write_box(const BoxFiles& files, const GriddedWind& wind, BoxOrder order = {});

}  // namespace lac::sim
