// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace lac::sim {

/// Exponential longitudinal coherence (GUO eq. 18). Squared:
/// gamma_x^2 = exp(-decay dx sqrt((f/U)^2 + offset^2)); the root has half the exponent.
struct ExponentialEvolution {
  double decay = 0.0;         // a_x [-]; 0: frozen
  double offset_per_m = 0.0;  // b_x

  double root_coherence(double dx_m, double frequency_hz, double mean_speed_mps) const {
    return std::exp(-0.5 * decay * dx_m * std::hypot(frequency_hz / mean_speed_mps, offset_per_m));
  }
};

}  // namespace lac::sim
