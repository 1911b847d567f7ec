// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "sim_harness/wind/velocity_grid.hpp"

namespace lac::sim {

/// From amplitudes to velocities, in the memory of the grid itself: for each point and component
///
///   u(t) = mean + sum over m = 1 .. of A_m e^(i 2 pi m t / T) and its conjugate,
///
/// A_m waiting as real part in time step 2 m - 1 and as imaginary part in 2 m. The last one of an
/// even number of steps (Nyquist) is real and enters once. mean_u_mps: of u, per height.
void amplitudes_to_series(VelocityGrid& grid, std::span<const float> mean_u_mps, int threads);

}  // namespace lac::sim
