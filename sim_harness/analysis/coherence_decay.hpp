// SPDX-License-Identifier: Apache-2.0
// Davenport's exponential decay of coherence along the wind (G18 eqs. 4 and 5, methods section 10).
#pragma once

#include <span>

namespace lac::sim {

struct DecayFit {
  double decay = 0.0;     // alpha in gamma^2 = exp(-alpha f T); NaN if nothing could be fitted
  double residual = 0.0;  // root of the weighted mean square of what is left of gamma^2
};

/// The alpha from 0 to 1000 that minimises sum S (gamma^2 - exp(-alpha f T))^2 / sum S over the
/// frequencies up to max_hz; gamma^2 the magnitude squared, S the density of the wind.
/// T = separation / mean speed [s] is G18's eq. 4; T = separation * sigma_u / speed^2 is the
/// variant of eq. 5, scaled with the turbulence intensity, with another alpha.
DecayFit fit_decay(std::span<const double> frequency_hz, std::span<const double> coherence,
                   std::span<const double> density, double travel_time_s, double max_hz);

}  // namespace lac::sim
