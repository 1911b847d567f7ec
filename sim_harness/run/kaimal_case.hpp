// SPDX-License-Identifier: Apache-2.0
// Case files: kind kaimal.
#pragma once

#include <iosfwd>

#include "sim_harness/run/turbulence_case.hpp"
#include "sim_harness/run/wind_case.hpp"

namespace lac::sim {

KaimalWind read_kaimal(YamlReader& in, const WindSurroundings& around);

/// Of planes up-wind what is demanded (nullptr: all); the shape is given to each.
std::unique_ptr<WindField> make_kaimal_wind(const KaimalWind& wind, const FlowShape& shape,
                                            const WindDemand* demand);

/// Closed form.
SigmaU sigma_u(const KaimalWind& wind);

/// For reports, without a line feed.
void describe(const KaimalWind& wind, std::ostream& out);

}  // namespace lac::sim
