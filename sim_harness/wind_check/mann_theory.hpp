// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/mann_tensor.hpp"
#include "sim_harness/wind_check/turbulence_theory.hpp"

namespace lac::sim {

/// Mann's tensor as it passes a plane: S(f) = 2 F_ii(k1) 2 pi / U, k1 = 2 pi f / U, root coherency
/// F_ii(k1, dy, dz) / F_ii(k1) of the tensor itself. A generated box repeats in y and z and differs
/// from it (MannBox): its coherence at a separation r is smaller by about sinc(pi r / period).
class MannTheory final : public TurbulenceTheory {
 public:
  MannTheory(const MannParams& params, double mean_speed_mps);

  /// From a table in log k1, k1 L from 1e-3 to 1e4, with a cubic between (relative error below
  /// 1e-3); beyond it the power law of the last two values.
  double spectrum(int component, double frequency_hz) const override;
  CoherencyTable coherencies(int component, double frequency_hz,
                             const Lattice& lattice) const override;
  std::string name() const override;

 private:
  MannTensor tensor_;
  double mean_speed_mps_;
  std::vector<std::array<double, 3>> log_spectra_;  // of F_ii(k1) at the steps
};

}  // namespace lac::sim
