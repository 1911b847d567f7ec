// SPDX-License-Identifier: Apache-2.0
// Case files: kind mann.
#pragma once

#include <iosfwd>

#include "sim_harness/run/turbulence_case.hpp"
#include "sim_harness/run/wind_case.hpp"

namespace lac::sim {

MannWind read_mann(YamlReader& in, const WindSurroundings& around);

/// Of planes up-wind what is demanded (nullptr: all); the shape is given to each.
std::unique_ptr<WindField> make_mann_wind(const MannWind& wind, const FlowShape& shape,
                                          const WindDemand* demand);

/// From the table of the box, which is made for it.
SigmaU sigma_u(const MannWind& wind);

/// For reports, without a line feed.
void describe(const MannWind& wind, std::ostream& out);

}  // namespace lac::sim
