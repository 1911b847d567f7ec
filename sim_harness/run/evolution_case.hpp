// SPDX-License-Identifier: Apache-2.0
// Case files: the planes of evolving wind, for every kind that has them.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim_harness/run/wind_case.hpp"
#include "sim_harness/wind/evolving_wind.hpp"

namespace lac::sim {

/// Key planes_m of a map `evolution`: distances from the rotor [m], rising; without it one plane at
/// each gate of the case's lidar. Throws lac::Error if there is neither, or if a gate is centred
/// beyond the last plane by more than half the distance between the last two, or its nearest plane
/// is less than half as far from the rotor as the gate.
std::vector<double> read_planes(YamlReader& evolution, const WindSurroundings& around);

/// Gives every plane the shape.
std::unique_ptr<WindField> shaped(EvolvingGrids grids, const FlowShape& shape);

using TakePlane = std::function<void(double distance_m, const GriddedWind& plane)>;

/// Draws whole planes of evolving wind one after the other, the rotor's first, each in memory alone
/// (besides what its generator keeps). Throws lac::Error if the wind does not evolve or is turned.
void make_planes(const WindCase& wind, const TakePlane& take);

/// In the frame of the wind: the points of the demand, and the rotor disk, which there cuts through
/// planes.
WindDemand turned(const WindDemand& demand, const WindCase& wind);

}  // namespace lac::sim
