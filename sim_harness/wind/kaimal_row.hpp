// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "sim_harness/wind/kaimal_source.hpp"
#include "sim_harness/wind/plane_sampler.hpp"

namespace lac::sim {

/// The amplitudes of one frequency, [component][z][y], as amplitudes_to_series() takes them. One
/// per thread. Numbers are drawn per seed, plane, component and frequency.
class KaimalRow {
 public:
  using Complex = std::complex<float>;

  explicit KaimalRow(const KaimalSource& source);

  std::size_t size() const { return 3 * drawn_.size(); }
  /// To be called first. Throws lac::Error if no sampler has the coherence of this frequency.
  void select(int m);
  /// Upper bound of what the coherence of any two points is off by.
  double coherence_error() const { return sampler_.coherence_error(); }

  /// Of the rotor plane, number 0.
  void draw(std::uint64_t seed, std::span<Complex> amplitudes);
  /// From a plane to the next one, dx further up-wind and of this number:
  /// A -> rho A + sqrt(1 - rho^2) A'.
  void evolve(double dx_m, std::uint64_t seed, std::size_t plane, std::span<Complex> amplitudes);

 private:
  void draw(int component, ComplexNormal normal);

  const KaimalSource& source_;
  int m_ = 0;
  CheapestSampler sampler_;
  std::vector<std::complex<double>> drawn_;  // of one component
};

}  // namespace lac::sim
