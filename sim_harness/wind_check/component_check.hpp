// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/wind_check/field_amplitudes.hpp"

namespace lac::sim {

/// What a field has and what theory says, and how much the former scatters among fields of the
/// theory: relative variance of a density or variance, variance of atanh of a coherence.
struct Estimate {
  double frequency_hz = 0.0;
  double found = 0.0;
  double expected = 0.0;
  double variance = 0.0;
};

/// One component of a field beside its theory. Holds references to the theory and the transform.
class ComponentCheck {
 public:
  /// Frequencies from the transform's first useful bin to below end_bin.
  ComponentCheck(const GriddedWind& wind, const TurbulenceTheory& theory, int component,
                 const GridSampling& sampling, const BlockTransform& transform,
                 std::size_t end_bin);

  /// Density per band [m^2/s^2/Hz].
  std::vector<Estimate> spectrum() const;
  /// Variance [m^2/s^2] over the bands of spectrum(); its frequency is the lowest.
  Estimate variance(const std::vector<Estimate>& spectrum) const;
  /// Real part of the root coherency per separation and band, where at least ten independent values
  /// are behind a band.
  std::vector<std::vector<Estimate>> coherence(const std::vector<LatticeSteps>& separations) const;

 private:
  std::vector<double> densities() const;
  double mean_density(const Band& band) const;
  double middle_hz(const Band& band) const;
  double scatter_of_points(double frequency_hz) const;
  std::vector<double> expected_coherences(const Band& band,
                                          const std::vector<LatticeSteps>& separations) const;

  const TurbulenceTheory& theory_;
  int component_;
  Lattice lattice_;
  const BlockTransform& transform_;
  std::size_t end_bin_;
  std::vector<double> expected_;
  std::vector<Band> bands_;
  std::vector<double> points_;  // scatter_of_points() of the bands
  FieldAmplitudes amplitudes_;
};

}  // namespace lac::sim
