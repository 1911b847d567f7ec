// SPDX-License-Identifier: Apache-2.0
// Mann's uniform-shear spectral tensor and its extension in time (Mann 1994; GUO eqs. 1-17;
// methods sections 2 and 3). Equations only: no fields, no files.
#pragma once

#include <array>
#include <complex>
#include <limits>
#include <vector>

namespace lac {

/// How long shear acts on an eddy: beta(kL) = dU/dz tau.
enum class EddyLifetime {
  kMann,  // Gamma (kL)^(-2/3) [2F1(1/3, 17/6; 4/3; -(kL)^-2)]^(-1/2)
  kGuo,   // Gamma a (kL)^b1 [(kL)^10 + 1]^((b2 - b1)/10), a = [2F1(...; -1)]^(-1/2)
};

struct MannParams {
  double alpha_epsilon = 0.311;  // alpha eps^(2/3) [m^(4/3) s^-2]: the tensor is proportional to it
  double length_m = 49.0;
  double gamma = 3.1;  // anisotropy; not the same number for both lifetimes: see beta()
  EddyLifetime lifetime = EddyLifetime::kGuo;
  double low_slope = -1.0;         // b1, kL -> 0; kGuo alone
  double high_slope = -2.0 / 3.0;  // b2, kL -> infinity; kGuo alone
  /// gamma of GUO eq. 15 [s]: how slowly eddies change on their way; infinity: frozen turbulence.
  double evolution_s = std::numeric_limits<double>::infinity();
};

/// Order of the six numbers of a tensor.
enum TensorIndex { kUu, kVv, kWw, kUv, kUw, kVw, kTensorSize };
using SpectralTensor = std::array<double, kTensorSize>;
using CrossSpectra = std::array<std::complex<double>, kTensorSize>;

/// From a point to another one, and how much later the field is taken there (in the frame that
/// moves with the wind: dt = dx / U for points dx apart).
struct Separation {
  double dy_m = 0.0;
  double dz_m = 0.0;
  double dt_s = 0.0;
};

/// Nodes of the trapezoid rule in t, k = s sinh(t), s = 0.3 |k1|, |k| <= reach (1/L + |k1|). The
/// tensor has structure on the scale of k1 about k2 = k3 = 0 and reaches to hundreds of 1/L.
struct SinhNodes {
  std::vector<double> k_radpm;  // from -max to max, symmetric
  std::vector<double> weight_radpm;

  /// nodes odd. Measured with the sets of GUO Table 1, k1 from 1e-4 to 10 rad/m: spectra at one
  /// point with 101 nodes are within 6e-6 of 2401, and the reach of 600 within 3e-5 of infinity.
  SinhNodes(double k1_radpm, double length_m, int nodes, double reach = 600.0);
};

class MannTensor {
 public:
  /// Throws lac::Error unless alpha_epsilon, length and evolution are above 0, gamma is 0 or above
  /// and the slopes are b1 <= b2 <= 0.
  explicit MannTensor(const MannParams& params);

  const MannParams& params() const { return params_; }

  /// Phi_ij [m^5/s^2] at a wave vector [rad/m], k1 not 0: real, symmetric, positive semidefinite,
  /// integral over all wave vectors the covariances. Phi(-k) = Phi(k); uv and vw are odd in k2.
  SpectralTensor operator()(double k1_radpm, double k2_radpm, double k3_radpm) const;

  /// Distortion of an eddy of |k| L = kl > 0, from a table of log beta over log kl: relative error
  /// below 2e-7 against closed_beta(), for the GUO form too. For kl -> infinity the GUO form is
  /// larger than Mann's by a = 1.23 with the same Gamma.
  double beta(double kl) const;
  /// The same from its equation.
  double closed_beta(double kl) const;

  /// tau_e [s] = evolution_s a (kL)^-1 [(kL)^10 + 1]^(-2/15) (GUO eq. 15).
  double evolution_time_s(double k_radpm) const;

  /// F_ij(k1, dy, dz) [m^3/s^2], two-sided in k1, the integral of Phi e^(i(k2 dy + k3 dz))
  /// e^(-dt/tau_e) over k2 and k3 (GUO 8, 17); the second point lies at (+dy, +dz) of the first.
  /// The nodes must resolve the oscillation: measured error, relative to the one-point spectrum,
  /// with 301 nodes 3e-5 at 20 m, 2e-4 at 60 m, 1e-3 at 150 m; with 601 nodes 1e-4 at 150 m; while
  /// k1 r < 6, beyond which the nodes no longer resolve the oscillation (0.03 at k1 r = 24).
  CrossSpectra cross_spectra(double k1_radpm, const Separation& separation, int nodes = 301) const;
  /// One-point spectra F_ij(k1), two-sided.
  SpectralTensor spectra(double k1_radpm, int nodes = 101) const;
  /// Covariances [m^2/s^2]: the integral of spectra() over k1 from -infinity to infinity, to 5e-5.
  SpectralTensor covariance() const;

 private:
  double log_beta_in_table(double log_kl) const;

  MannParams params_;
  std::vector<double> log_beta_;
};

/// The same turbulence with alpha_epsilon such that the standard deviation of u is as given.
MannParams scaled_to_sigma_u(MannParams params, double sigma_u_mps);

}  // namespace lac
