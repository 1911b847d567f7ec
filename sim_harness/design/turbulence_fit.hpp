// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/mann_tensor.hpp"
#include "sim_harness/design/kaimal_correlation.hpp"

namespace lac::sim {

/// Wavenumbers and separations of the fits; GUO's.
struct FitSettings {
  double first_k1_radpm = 1e-4;
  double last_k1_radpm = 1.0;
  int points = 25;
  double dy_m = 20.0;  // of the coherence across
  double dz_m = 20.0;
  double dx_m = 100.0;  // of the coherence along
  double mean_speed_mps = 16.0;
};

/// The Kaimal spectra and exponential coherences closest to a Mann tensor, by least squares over
/// wavenumbers equally spaced in log k1 (GUO eqs. 20-22, methods section 3):
///
///   sigma_i, L_i   sum (f S_i - 2 k1 F_ii)^2, each component for itself
///   a_yz, L_c      sum (gamma_yz^2 - cocoh^2)^2 / k1, u at the distance across
///   a_x, b_x       sum (gamma_x^2 - coh^2)^2 / k1, u at the distance along
///
/// GUO print the weight 1/k1 for all, and roots in the second, without saying how their wavenumbers
/// are spaced; these choices come closest to their Tables 1 and 2. A negative cocoh keeps its sign.
/// Throws lac::Error if the tensor does not evolve.
KaimalTurbulence fit_kaimal(const MannParams& mann, const FitSettings& settings = {});

}  // namespace lac::sim
