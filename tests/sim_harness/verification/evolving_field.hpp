// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "sim_harness/wind/evolving_wind.hpp"

namespace lac::sim {

/// Evolving wind from a generator of planes (KaimalPlanes, MannPlanes), every point kept.
template <class Planes>
EvolvingWind evolving_field(Planes& planes, const std::vector<double>& upwind_m) {
  PlaneLayout layout(upwind_m);
  VelocityGrid rotor = planes.next(0.0).take_grid();
  const std::vector<GridColumns> columns = demanded_columns(layout, rotor.spec(), nullptr);
  std::vector<ThinnedGrid> upwind;
  for (std::size_t i = 0; i < upwind_m.size(); ++i)
    upwind.emplace_back(planes.next(upwind_m[i]).grid(), columns[i]);
  return EvolvingWind({std::move(layout), std::move(rotor), std::move(upwind)});
}

}  // namespace lac::sim
