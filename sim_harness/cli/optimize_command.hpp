// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>

#include "sim_harness/cli/design_command.hpp"

namespace lac::sim {

/// `lac optimize`: the beams and gates with the highest k0.5 for the turbulence and rotor of a
/// design file (docs/design.md). Prints the table; writes map.csv, map.html and lidar.yaml. Throws
/// lac::Error.
void optimize_command(const DesignOptions& options, std::ostream& out);

}  // namespace lac::sim
