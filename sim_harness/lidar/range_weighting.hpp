// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

/// Shape of the probe volume along the beam, s from the centre of the gate:
///
///   kGaussian    phi ~ exp(-s^2/(2 sigma^2)), sigma = FWHM/(2 sqrt(2 ln 2))  (GUO eq. 27)
///                transform exp(-k^2 sigma^2/2)
///   kPulse       phi ~ erf((s + g/2)/(sigma sqrt 2)) - erf((s - g/2)/(sigma sqrt 2)),
///                a Gaussian pulse seen through a gate of length g (Cariou, Remote Sensing for
///                Wind Energy, ch. 5); transform exp(-k^2 sigma^2/2) sin(k g/2)/(k g/2)
///   kLorentzian  phi = z_R/(pi (z_R^2 + s^2))  (HM eq. 19), z_R growing with the square of the
///                focus distance; transform exp(-|k| z_R)
enum class ProbeKind { kGaussian, kPulse, kLorentzian };

/// What one range gate sees along its beam, always scaled to a sum of one.
struct RangeWeighting {
  ProbeKind kind = ProbeKind::kGaussian;
  double fwhm_m = 30.0;             // kGaussian: full width at half maximum; 0: the point itself
  double pulse_length_m = 30.0;     // kPulse: FWHM of the pulse in range, c tau/2
  double gate_length_m = 30.0;      // kPulse: length of the gate in range
  double rayleigh_length_m = 10.0;  // kLorentzian: z_R ...
  double rayleigh_at_m = 100.0;     // ... of a focus at this distance
  /// kLorentzian: the tails are cut at this many z_R, or at the lidar if that is nearer. The part
  /// left out is t = 2/pi atan(1/reach), 6.3 % at 10 (as HM cut them); the transform is wrong by
  /// t (1 + exp(-|k| z_R))/(1 - t) at most.
  double reach_rayleigh = 10.0;
  int points = 9;  // of the quadrature

  bool is_point() const { return kind == ProbeKind::kGaussian && fwhm_m == 0.0; }
  /// Standard deviation of the Gaussian or of the pulse.
  double sigma_m() const;
  double rayleigh_m(double range_m) const;
  /// kGaussian, kPulse: how far from the centre weights are taken, three sigma and half a gate.
  double reach_m() const;
  /// kGaussian, kPulse: phi up to a factor.
  double shape(double s_m) const;
};

/// Keys: probe (gaussian, pulse, continuous_wave, point) and those of the shape:
/// fwhm_m; pulse_length_m, gate_length_m; rayleigh_length_m, rayleigh_at_m,
/// reach_rayleigh_lengths; weighting_points. Lengths are 0.01 m or more, fwhm_m may be 0. Throws
/// lac::Error.
RangeWeighting read_range_weighting(YamlReader& in);

}  // namespace lac::sim
