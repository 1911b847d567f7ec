// SPDX-License-Identifier: Apache-2.0
// How much means over the points of a lattice scatter. The points of a field are correlated, the
// more so at low frequency, so n of them are worth fewer than n independent ones. For complex
// normal amplitudes (Isserlis): cov(A_i A_j*, A_k A_l*) = g_ik g_lj.
#pragma once

#include "sim_harness/wind_check/turbulence_theory.hpp"

namespace lac::sim {

/// Relative variance of the mean of |A|^2 over all points, for one realisation: 1 / n for
/// independent points, 1 for points that do the same.
double variance_of_mean_power(const CoherencyTable& coherency);

/// Variance, for one realisation and to first order, of atanh of
///   g = sum Re(A_i A_j*) / sqrt(sum |A_i|^2 sum |A_j|^2)
/// over all pairs of points (i, j = i + (y, z) steps); (1/2) / n for n independent pairs, as in
/// Fisher's transformation. y, z >= 0 and within the lattice, not both 0.
double variance_of_coherence(const CoherencyTable& coherency, int y, int z);

}  // namespace lac::sim
