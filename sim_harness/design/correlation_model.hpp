// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <vector>

namespace lac::sim {

/// Spectra of the rotor-effective wind speed R and of its lidar estimate L at one wavenumber
/// [m^3/s^2], two-sided in k1; one-sided in f they are 4 pi / U times that.
struct RotorLidarSpectra {
  double s_rr = 0.0;
  /// By the nearest plane in use: [0] all planes, [m] the nearest m left out.
  std::vector<double> s_ll;
  std::vector<std::complex<double>> s_rl;  // <R* L>: a phase above 0 where L is late
};

/// REWS: the mean of u over the rotor disk (GUO eq. 23). Estimate: the mean of v_los / n_x over all
/// volumes (GUO eq. 28), each gate delayed by its distance over U.
class CorrelationModel {
 public:
  virtual ~CorrelationModel() = default;

  /// For each mean wind speed. k1 > 0.
  virtual std::vector<RotorLidarSpectra> at(double k1_radpm,
                                            const std::vector<double>& speeds_mps) const = 0;
};

}  // namespace lac::sim
