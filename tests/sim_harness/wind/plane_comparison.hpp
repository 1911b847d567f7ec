// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "sim_harness/wind/evolving_wind.hpp"

namespace lac::sim {

inline bool same_bits(const VelocityGrid& a, const VelocityGrid& b) {
  for (int it = 0; it < a.spec().nt; ++it) {
    if (!std::ranges::equal(a.plane(it), b.plane(it))) return false;
  }
  return true;
}

/// Whether the planes are those that a generator gives one by one (KaimalPlanes, MannPlanes; not
/// begun yet), to the last bit, where they were kept.
template <class Planes>
bool same_as_one_by_one(const EvolvingGrids& grids, Planes planes) {
  bool same = same_bits(planes.next(0.0).take_grid(), grids.rotor);
  for (std::size_t i = 0; i < grids.upwind.size(); ++i) {
    const ThinnedGrid& found = grids.upwind[i];
    const VelocityGrid whole = planes.next(grids.layout.distance_m(i + 1)).take_grid();
    const ThinnedGrid expected(whole, found.columns());
    for (std::size_t c = 0; c < found.columns().count(); ++c)
      same = same && std::ranges::equal(found.column(c), expected.column(c));
  }
  return same;
}

}  // namespace lac::sim
