// SPDX-License-Identifier: Apache-2.0
// Wind conditions of IEC 61400-1 ed. 3 (2005 with amendment 1) and ed. 4 (2019), methods section
// 14. The equations below are the same in both; ed. 4 adds the turbulence category A+ (and a class
// T for tropical cyclones, which acts on the extreme wind speed model only, not given here).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace lac::sim {

enum class WindClass { kI, kII, kIII };
enum class TurbulenceCategory { kA, kB, kC, kAPlus };

struct IecClass {
  WindClass wind = WindClass::kI;
  TurbulenceCategory turbulence = TurbulenceCategory::kA;
};

/// Reference speed V_ref [m/s]: 50, 42.5, 37.5 (table 1).
constexpr double reference_speed_mps(WindClass wind) {
  return wind == WindClass::kI ? 50.0 : wind == WindClass::kII ? 42.5 : 37.5;
}

/// Expected turbulence intensity at 15 m/s, I_ref [-]: A+ 0.18, A 0.16, B 0.14, C 0.12 (table 1).
constexpr double reference_turbulence(TurbulenceCategory turbulence) {
  switch (turbulence) {
    case TurbulenceCategory::kAPlus:
      return 0.18;
    case TurbulenceCategory::kA:
      return 0.16;
    case TurbulenceCategory::kB:
      return 0.14;
    default:
      return 0.12;
  }
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

/// Lengths T [s] of the transient events.
inline constexpr double kEogDuration_s = 10.5;
inline constexpr double kEdcDuration_s = 6.0;
inline constexpr double kEcdDuration_s = 10.0;
inline constexpr double kEwsDuration_s = 12.0;

/// 1 + 0.1 D / Lambda_1: how a rotor averages what is smaller than itself.
constexpr double rotor_size_factor(double hub_height_m, double rotor_diameter_m) {
  return 1.0 + 0.1 * rotor_diameter_m / turbulence_scale_m(hub_height_m);
}

/// Gust magnitude V_gust [m/s] at the hub: min(1.35 (V_e1 - V), 3.3 sigma_1/(1 + 0.1 D/Lambda_1)),
/// V_e1 = 0.8 * 1.4 V_ref.
constexpr double eog_magnitude_mps(const IecClass& iec, double mean_speed_mps, double hub_height_m,
                                   double rotor_diameter_m) {
  const double v_e1_mps = 0.8 * 1.4 * reference_speed_mps(iec.wind);
  return std::min(1.35 * (v_e1_mps - mean_speed_mps),
                  3.3 * ntm_sigma_mps(iec.turbulence, mean_speed_mps) /
                      rotor_size_factor(hub_height_m, rotor_diameter_m));
}

/// What the gust adds to the mean speed [m/s], t counted from its start; 0 outside of it.
/// Peak +0.74 V_gust at T/2; dips -0.888 * 0.45^1.5 V_gust (-0.268) where sin^2(pi t/T) = 0.45.
inline double eog_deviation_mps(double magnitude_mps, double time_in_gust_s) {
  if (!(time_in_gust_s > 0.0 && time_in_gust_s < kEogDuration_s)) return 0.0;
  const double phase_rad = kPi * time_in_gust_s / kEogDuration_s;
  return -0.37 * magnitude_mps * std::sin(3.0 * phase_rad) * (1.0 - std::cos(2.0 * phase_rad));
}

/// Extreme direction change theta_e [rad]: 4 atan(sigma_1 / (V (1 + 0.1 D / Lambda_1))), at most
/// 180 deg; both signs are to be looked at.
inline double edc_angle_rad(TurbulenceCategory turbulence, double mean_speed_mps,
                            double hub_height_m, double rotor_diameter_m) {
  const double ratio = ntm_sigma_mps(turbulence, mean_speed_mps) / mean_speed_mps /
                       rotor_size_factor(hub_height_m, rotor_diameter_m);
  return std::min(4.0 * std::atan(ratio), kPi);
}

/// Extreme coherent gust with direction change: V_cg [m/s], and theta_cg [rad] that comes with it,
/// 180 deg below 4 m/s, (720 m/s) / V deg above.
inline constexpr double kEcdGust_mps = 15.0;
constexpr double ecd_angle_rad(double mean_speed_mps) {
  return rad_from_deg(mean_speed_mps < 4.0 ? 180.0 : 720.0 / mean_speed_mps);
}

/// Half-cosine rise of direction and speed in EDC and ECD: 0 before, 1 after duration_s.
inline double half_cosine_rise(double time_in_event_s, double duration_s) {
  if (!(time_in_event_s > 0.0)) return 0.0;
  if (time_in_event_s >= duration_s) return 1.0;
  return 0.5 * (1.0 - std::cos(kPi * time_in_event_s / duration_s));
}

/// Extreme wind shear: A = 2.5 m/s + 0.2 beta sigma_1 (D / Lambda_1)^(1/4), beta = 6.4. The event
/// adds +-A (1 - cos(2 pi t / T)) (z - z_hub) / D, or the same with y / D: at the rim +-A when it
/// is strongest.
inline double ews_amplitude_mps(TurbulenceCategory turbulence, double mean_speed_mps,
                                double hub_height_m, double rotor_diameter_m) {
  constexpr double kBeta = 6.4;
  return 2.5 + 0.2 * kBeta * ntm_sigma_mps(turbulence, mean_speed_mps) *
                   std::pow(rotor_diameter_m / turbulence_scale_m(hub_height_m), 0.25);
}

/// 1 - cos(2 pi t / T) during the event, 0 outside of it.
inline double ews_shape(double time_in_event_s) {
  if (!(time_in_event_s > 0.0 && time_in_event_s < kEwsDuration_s)) return 0.0;
  return 1.0 - std::cos(2.0 * kPi * time_in_event_s / kEwsDuration_s);
}

}  // namespace lac::sim
