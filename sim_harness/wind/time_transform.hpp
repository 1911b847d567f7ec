// SPDX-License-Identifier: Apache-2.0
// From amplitudes to velocities, in the memory of the grid itself: for each point and component
//
//   u(t) = mean + sum over m = 1 .. of A_m e^(i 2 pi m t / T) and its conjugate,
//
// A_m waiting as real part in time step 2 m - 1 and as imaginary part in 2 m. The last one of an
// even number of steps (Nyquist) is real and enters once. A column of a thinned grid comes out as
// it does in the whole grid, to the last bit.
#pragma once

#include <complex>
#include <span>

#include "sim_harness/wind/thinned_grid.hpp"

namespace lac::sim {

/// Puts the amplitudes of one component at harmonic m, those of all points of the grid, [z][y], to
/// where amplitudes_to_series() looks for them; of a Nyquist amplitude the real part.
void put_amplitudes(std::span<const std::complex<float>> amplitudes, int component, int m,
                    VelocityGrid& grid);
void put_amplitudes(std::span<const std::complex<float>> amplitudes, int component, int m,
                    ThinnedGrid& grid);

/// mean_u_mps: of u, per height.
void amplitudes_to_series(VelocityGrid& grid, std::span<const float> mean_u_mps, int threads);
void amplitudes_to_series(ThinnedGrid& grid, std::span<const float> mean_u_mps, int threads);

}  // namespace lac::sim
