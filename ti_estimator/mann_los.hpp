// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/mann_tensor.hpp"
#include "core/vec3.hpp"

namespace lac {

/// Spectrum over k1, two-sided [m^3/s^2], from a table: log over log, cubic, level below its first
/// node (as Mann's are) and 0 above the last one.
class TabulatedSpectrum {
 public:
  TabulatedSpectrum() = default;
  /// Of `values` > 0 at k1 = first exp(i step).
  TabulatedSpectrum(double first_k1_radpm, double log_step, const std::vector<double>& values);
  double at(double k1_radpm) const;

 private:
  double first_log_ = 0.0;
  double log_step_ = 1.0;
  std::vector<double> logs_;
};

/// What a lidar volume, Gaussian of standard deviation s along the beam n, sees of Mann's
/// turbulence (methods sections 2 and 6):
///   F_los(k1) = int int n_i n_j Phi_ij(k) exp(-(s k . n)^2) dk2 dk3,
/// all components and their covariances: a beam that looks up sees another variance than one that
/// looks down. Trapezoid rule over SinhNodes; the tensor is computed once for all beams.
class MannLos {
 public:
  /// Spectra are good up to highest_k1_radpm.
  MannLos(const MannParams& params, double volume_std_m, double highest_k1_radpm);

  /// `beam_I`: unit vector in the frame whose x is down-wind and z up.
  TabulatedSpectrum los(const Vec3& beam_I) const;
  /// Of u at a point.
  TabulatedSpectrum u() const;

 private:
  /// Nodes of one k1; k2 >= 0 alone, as uv and vw are odd in it and the others even.
  struct Sheet {
    double k1_radpm = 0.0;
    std::vector<double> k2_radpm, k3_radpm;
    std::vector<SpectralTensor> weighted;  // [k2][k3]
  };
  double los_at(const Sheet& sheet, const Vec3& n) const;

  double volume_std_m_;
  std::vector<Sheet> sheets_;
};

}  // namespace lac
