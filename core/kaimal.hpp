// SPDX-License-Identifier: Apache-2.0
// Kaimal one-point spectra and exponential coherence, IEC 61400-1 form (GUO eqs. 11, 12;
// methods section 1). One-sided in f: the integral of S over f from 0 to infinity is sigma^2.
#pragma once

#include <cmath>

namespace lac {

struct KaimalComponent {
  double sigma_mps = 1.0;
  double length_scale_m = 340.2;

  /// S(f) [m^2/s^2/Hz] at mean speed U; f >= 0.
  double spectrum(double frequency_hz, double mean_speed_mps) const {
    const double t_s = length_scale_m / mean_speed_mps;
    return 4.0 * sigma_mps * sigma_mps * t_s / std::pow(1.0 + 6.0 * frequency_hz * t_s, 5.0 / 3.0);
  }

  /// Variance [m^2/s^2] between two frequencies, closed form.
  double variance(double f1_hz, double f2_hz, double mean_speed_mps) const {
    const double a = 6.0 * length_scale_m / mean_speed_mps;
    return sigma_mps * sigma_mps *
           (std::pow(1.0 + a * f1_hz, -2.0 / 3.0) - std::pow(1.0 + a * f2_hz, -2.0 / 3.0));
  }
};

/// u, v, w spectra and the yz-coherence that goes with them.
struct KaimalModel {
  KaimalComponent u{1.0, 340.2};
  KaimalComponent v{0.8, 113.4};
  KaimalComponent w{0.5, 27.72};
  double coherence_decay = 12.0;      // a_yz [-]
  double coherence_length_m = 340.2;  // L_c

  /// The c of gamma = exp(-c r) [1/m]: root coherence, not squared.
  double coherence_rate(double frequency_hz, double mean_speed_mps) const {
    return coherence_decay * std::hypot(frequency_hz / mean_speed_mps, 0.12 / coherence_length_m);
  }
  /// Root coherence between two points r apart in the yz-plane.
  double root_coherence(double r_m, double frequency_hz, double mean_speed_mps) const {
    return std::exp(-r_m * coherence_rate(frequency_hz, mean_speed_mps));
  }
};

/// IEC 61400-1: Lambda_1 from the hub height, sigma_v = 0.8 sigma_u, sigma_w = 0.5 sigma_u.
inline KaimalModel iec_kaimal(double sigma_u_mps, double hub_height_m) {
  const double lambda_m = hub_height_m <= 60.0 ? 0.7 * hub_height_m : 42.0;
  KaimalModel model;
  model.u = {sigma_u_mps, 8.1 * lambda_m};
  model.v = {0.8 * sigma_u_mps, 2.7 * lambda_m};
  model.w = {0.5 * sigma_u_mps, 0.66 * lambda_m};
  model.coherence_length_m = 8.1 * lambda_m;
  return model;
}

}  // namespace lac
