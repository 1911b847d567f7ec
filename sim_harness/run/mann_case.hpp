// SPDX-License-Identifier: Apache-2.0
// Case files: kind mann.
#pragma once

#include <iosfwd>

#include "sim_harness/run/wind_case.hpp"

namespace lac::sim {

MannWind read_mann(YamlReader& in, const WindSurroundings& around);

/// Draws plane after plane and gives each the shape.
std::unique_ptr<WindField> make_mann_wind(const MannWind& wind, const FlowShape& shape);

/// For reports, without a line feed.
void describe(const MannWind& wind, std::ostream& out);

}  // namespace lac::sim
