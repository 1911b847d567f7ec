// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "sim_harness/wind/wind_demand.hpp"

namespace lac::sim {

/// Where the planes of evolving wind are: number 0 at the rotor, the others at distances up-wind.
class PlaneLayout {
 public:
  /// Distances up-wind [m], above 0 and rising. Throws lac::Error unless they are.
  explicit PlaneLayout(std::vector<double> upwind_m);

  std::size_t size() const { return distances_m_.size(); }
  double distance_m(std::size_t plane) const { return distances_m_[plane]; }
  double last_m() const { return distances_m_.back(); }

  /// The plane nearest to a point this far up-wind: half-way points belong to the nearer plane to
  /// the rotor; down-wind of the rotor plane 0 holds, up-wind of the last plane the last one.
  std::size_t nearest(double distance_m) const {
    std::size_t plane = 0;
    while (plane < borders_m_.size() && distance_m > borders_m_[plane]) ++plane;
    return plane;
  }

  /// How far up-wind of the last plane a gate may be centred: half the distance from the last plane
  /// but one.
  double reach_m() const { return last_m() + (last_m() - borders_m_.back()); }

 private:
  std::vector<double> distances_m_;  // the rotor's 0 in front
  std::vector<double> borders_m_;    // half-way between neighbours
};

/// One plane for each gate: the mean distance up-wind of its centres over the beams, rising. Where
/// the beams' distances have a gap of more than 10 m (beams with gates of their own) there is one
/// for each group. Throws lac::Error if a distance is not above 0, or there are no gates.
std::vector<double> planes_at_gates(const WindDemand& demand);

}  // namespace lac::sim
