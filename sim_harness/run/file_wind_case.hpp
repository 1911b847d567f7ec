// SPDX-License-Identifier: Apache-2.0
// Case files: the kinds of wind that come from files.
#pragma once

#include <iosfwd>

#include "sim_harness/run/wind_case.hpp"

namespace lac::sim {

/// Key file.
FieldFile read_bts_kind(YamlReader& in);
FieldFile read_bladed_kind(YamlReader& in);

/// Keys file, points, spacing_m, mean_speed_mps, centre_height_m (hub height), first_plane, rows.
FieldFile read_box_kind(YamlReader& in, const WindSurroundings& around);

/// Keys file, advection_speed_mps; the file itself is read here.
UniformWindParams read_uniform_file_kind(YamlReader& in, const WindSurroundings& around);

/// For reports, without a line feed.
void describe(const FieldFile& file, std::ostream& out);

}  // namespace lac::sim
