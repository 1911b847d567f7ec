// SPDX-License-Identifier: Apache-2.0
// Ready parameter sets for three classes of atmospheric stability (GUO Tables 1 and 2).
#pragma once

#include "core/kaimal.hpp"
#include "core/mann_tensor.hpp"
#include "sim_harness/wind/kaimal_evolution.hpp"

namespace lac::sim {

enum class Stability { kUnstable, kNeutral, kStable };

/// GUO scale every class to one turbulence intensity: sigma_u at 16 m/s in IEC class 1A.
inline constexpr double kStabilitySigmaU_mps = 2.82;

/// Table 1 and the evolution used with it (600, 400, 200 s). sigma_u of these numbers is 2.75,
/// 2.77, 2.81 m/s; see scaled_to_sigma_u(). b1 of the stable class is -0.8: not printed, but the
/// stable row of Table 2 needs it.
inline MannParams stability_mann(Stability stability) {
  MannParams p;
  switch (stability) {
    case Stability::kUnstable:
      p.alpha_epsilon = 0.184, p.length_m = 140.0, p.gamma = 2.6, p.evolution_s = 600.0;
      break;
    case Stability::kNeutral:
      p.alpha_epsilon = 0.311, p.length_m = 49.0, p.gamma = 3.1, p.evolution_s = 400.0;
      break;
    case Stability::kStable:
      p.alpha_epsilon = 0.652, p.length_m = 30.0, p.gamma = 2.4, p.evolution_s = 200.0;
      p.low_slope = -0.8;
      break;
  }
  return p;
}

/// Table 1, fitted to the Mann set: spectra, and coherence at dy = dz = 20 m (the neutral one is
/// IEC's for 90 m, with a larger sigma_v); all sigma scaled.
inline KaimalModel stability_kaimal(Stability stability, double sigma_u_mps) {
  const double s = sigma_u_mps / kStabilitySigmaU_mps;
  switch (stability) {
    case Stability::kUnstable:
      return {{s * 2.82, 744.8}, {s * 2.34, 181.9}, {s * 1.98, 126.4}, 6.5, 1502.0};
    case Stability::kNeutral:
      return {{s * 2.82, 340.2}, {s * 2.25, 113.4}, {s * 1.41, 27.72}, 12.0, 340.2};
    default:
      return {{s * 2.82, 101.1}, {s * 2.26, 33.3}, {s * 1.83, 27.0}, 13.1, 101.1};
  }
}

/// Table 2 for the evolution of stability_mann(), fitted at 100 m.
inline ExponentialEvolution stability_evolution(Stability stability) {
  switch (stability) {
    case Stability::kUnstable:
      return {4.1, 7.67e-5};
    case Stability::kNeutral:
      return {1.8, 1.49e-4};
    default:
      return {1.6, 9.18e-4};
  }
}

}  // namespace lac::sim
