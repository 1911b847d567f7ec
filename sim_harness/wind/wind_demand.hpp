// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/vec3.hpp"

namespace lac::sim {

/// Centre of one range gate of one beam, both counted from 1, as users do.
struct GateCentre {
  int beam = 1;
  int gate = 1;
  Vec3 position_I_m;
};

/// Where a simulation will ask for the wind besides the rotor plane, in frame I: what a field may
/// keep the surroundings of and forget the rest.
struct WindDemand {
  std::vector<GateCentre> gates;
  std::vector<Vec3> points_I_m;  // every one, without what margin_m covers
  double margin_m = 0.0;         // how far motion may take any of them
};

}  // namespace lac::sim
