// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/design/design_case.hpp"

namespace lac::sim {

/// Relative change of |G_RL| at the cut-off, the largest of the first and the last wind speed, with
/// nearly twice the nodes per axis, twice the reach and twice the points along each beam.
double quadrature_error(const DesignCase& design, const std::vector<FeedforwardPoint>& points);

}  // namespace lac::sim
