// SPDX-License-Identifier: Apache-2.0
// Wind conditions of IEC 61400-1 ed. 3 (methods section 14).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace lac::sim {

enum class WindClass { kI, kII, kIII };
enum class TurbulenceCategory { kA, kB, kC };

struct IecClass {
  WindClass wind = WindClass::kI;
  TurbulenceCategory turbulence = TurbulenceCategory::kA;
};

/// Reference speed V_ref [m/s]: 50, 42.5, 37.5 (table 1).
constexpr double reference_speed_mps(WindClass wind) {
  return wind == WindClass::kI ? 50.0 : wind == WindClass::kII ? 42.5 : 37.5;
}

/// Expected turbulence intensity at 15 m/s, I_ref [-]: 0.16, 0.14, 0.12 (table 1).
constexpr double reference_turbulence(TurbulenceCategory turbulence) {
  return turbulence == TurbulenceCategory::kA   ? 0.16
         : turbulence == TurbulenceCategory::kB ? 0.14
                                                : 0.12;
}

/// Turbulence scale Lambda_1 [m]: 0.7 z_hub, at most 42 m.
constexpr double turbulence_scale_m(double hub_height_m) {
  return 0.7 * std::min(hub_height_m, 60.0);
}

/// Normal turbulence model: sigma_1 [m/s] of u, the 90 % quantile, at hub-height mean speed.
constexpr double ntm_sigma_mps(TurbulenceCategory turbulence, double mean_speed_mps) {
  return reference_turbulence(turbulence) * (0.75 * mean_speed_mps + 5.6);
}

/// Extreme turbulence model: sigma_1 [m/s] of u; V_ave = 0.2 V_ref, c = 2 m/s.
constexpr double etm_sigma_mps(const IecClass& iec, double mean_speed_mps) {
  constexpr double kC = 2.0;
  const double v_ave_mps = 0.2 * reference_speed_mps(iec.wind);
  return kC * reference_turbulence(iec.turbulence) *
         (0.072 * (v_ave_mps / kC + 3.0) * (mean_speed_mps / kC - 4.0) + 10.0);
}

/// Extreme operating gust: its length T [s].
inline constexpr double kEogDuration_s = 10.5;

/// Gust magnitude V_gust [m/s] at the hub: min(1.35 (V_e1 - V), 3.3 sigma_1/(1 + 0.1 D/Lambda_1)),
/// V_e1 = 0.8 * 1.4 V_ref.
constexpr double eog_magnitude_mps(const IecClass& iec, double mean_speed_mps, double hub_height_m,
                                   double rotor_diameter_m) {
  const double v_e1_mps = 0.8 * 1.4 * reference_speed_mps(iec.wind);
  const double size = 1.0 + 0.1 * rotor_diameter_m / turbulence_scale_m(hub_height_m);
  return std::min(1.35 * (v_e1_mps - mean_speed_mps),
                  3.3 * ntm_sigma_mps(iec.turbulence, mean_speed_mps) / size);
}

/// What the gust adds to the mean speed [m/s], t counted from its start; 0 outside of it.
/// Peak +0.74 V_gust at T/2; dips -0.888 * 0.45^1.5 V_gust (-0.268) where sin^2(pi t/T) = 0.45.
inline double eog_deviation_mps(double magnitude_mps, double time_in_gust_s) {
  if (!(time_in_gust_s > 0.0 && time_in_gust_s < kEogDuration_s)) return 0.0;
  const double phase_rad = kPi * time_in_gust_s / kEogDuration_s;
  return -0.37 * magnitude_mps * std::sin(3.0 * phase_rad) * (1.0 - std::cos(2.0 * phase_rad));
}

}  // namespace lac::sim
