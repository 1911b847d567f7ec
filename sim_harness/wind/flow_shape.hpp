// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sim_harness/wind/thinned_grid.hpp"

namespace lac::sim {

/// What can be done to the numbers of a gridded field, height by height, in this order. The mean of
/// a height is that of its component over y and all time steps.
///
/// 1. fluctuation_scale: what differs from the mean of the height is multiplied, (u, v, w).
/// 2. shear_exponent: U ((z / z_hub)^a - 1) is added to u; U and z_hub are the grid's. A profile
///    that is there already stays.
/// 3. veer: mean and fluctuation turn about the vertical by veer (z - z_hub), clockwise seen from
///    above with height (towards -y), as wind does in the northern boundary layer. u stays along
///    the local mean wind.
///
/// The planes themselves travel along x with U as before.
struct FlowShape {
  std::array<double, 3> fluctuation_scale{1.0, 1.0, 1.0};
  double shear_exponent = 0.0;
  double veer_radpm = 0.0;

  bool operator==(const FlowShape&) const = default;
};

/// Throws lac::Error if a scale is below 0, a value is not finite or the exponent meets z = 0.
void apply(const FlowShape& shape, VelocityGrid& grid);
/// The mean of a height is that of the columns kept: the same in generated fields, where each point
/// has the mean profile as its mean over the period, to rounding.
void apply(const FlowShape& shape, ThinnedGrid& grid);

}  // namespace lac::sim
