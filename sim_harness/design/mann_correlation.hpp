// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/mann_tensor.hpp"
#include "sim_harness/design/correlation_model.hpp"
#include "sim_harness/design/lidar_volumes.hpp"

namespace lac::sim {

/// Nodes of each of the two axes, odd, and their reach (see SinhNodes). Wider scans need more:
/// docs/design.md has measured errors.
struct MannQuadrature {
  int nodes = 101;
  double reach = 30.0;
};

/// Mann's tensor, evolving with its own time scale (methods section 4; GUO eqs. 24, 29, 32; HM eqs.
/// 13, 22, 24):
///
///   S_RR = ∫∫ Phi_11 D^2 dk2 dk3,   D = 2 J1(kappa R)/(kappa R),  kappa^2 = k2^2 + k3^2
///   A_g  = 1/n sum over volumes of plane g of (n / n_x) phi^(k.n) e^(i k.x)
///   S_LL = ∫∫ sum_gh A_g^H Phi A_h e^(-|t_g - t_h|/tau_e),   t = distance / U
///   S_RL = ∫∫ sum_g (Phi A_g)_1 e^(-t_g/tau_e) D
///
/// The exponential of a sum is a product, so B_g = A_g + e^(-(t_(g+1) - t_g)/tau_e) B_(g+1), from
/// the farthest plane to the nearest, holds all that is farther, and S_LL = ∫∫ sum_g Re[(Phi A_g)^*
/// . (2 B_g - A_g)]: the cost is linear in the planes, and the sums of fewer planes come with it.
/// One tensor serves all wind speeds.
class MannCorrelation : public CorrelationModel {
 public:
  /// Throws lac::Error on parameters of turbulence or quadrature out of range.
  MannCorrelation(const MannParams& turbulence, LidarVolumes lidar, double rotor_radius_m,
                  const MannQuadrature& quadrature = {});

  std::vector<RotorLidarSpectra> at(double k1_radpm,
                                    const std::vector<double>& speeds_mps) const override;

 private:
  MannTensor tensor_;
  LidarVolumes lidar_;
  double rotor_radius_m_;
  MannQuadrature quadrature_;
  bool mirrored_;  // left and right are alike: half of the k2 will do
};

}  // namespace lac::sim
