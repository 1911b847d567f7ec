// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <span>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "sim_harness/wind/complex_normal.hpp"
#include "sim_harness/wind/mann_box.hpp"

namespace lac::sim {

/// The amplitudes of one wavenumber k1 of a box: noise, colour, transform over y and z. One per
/// thread. Noise is [component][k3][k2], each number complex normal with E|n|^2 = 1.
class MannRow {
 public:
  using Complex = std::complex<float>;

  explicit MannRow(const MannBox& box);

  std::size_t noise_size() const { return 3 * points_; }
  /// To be called first.
  void select(double k1_radpm);
  static void draw(ComplexNormal& normal, std::span<Complex> noise);
  /// n -> rho n + sqrt(1 - rho^2) n', rho = exp(-lead / tau_e) of each cell.
  void evolve(double lead_s, ComplexNormal& normal, std::span<Complex> noise) const;
  /// h = C n, C C^T the tensor of the cell [m^3/s^2].
  void colour(std::span<const Complex> noise);
  /// scale times the sum over (k2, k3) of h e^(-i (k2 y + k3 z)) at the first ny by nz points,
  /// [z][y]; takes h of the component apart. With e^(i k1 U t) in time this is the conjugate of the
  /// field at x = -U t, which has the same statistics.
  std::span<const Complex> transform(int component, int ny, int nz, float scale);

 private:
  /// Lower triangular C of one cell, C C^T its tensor. An incompressible tensor is singular, so
  /// pivots may be rounding alone: they are left out.
  struct Factor {
    float uu, vu, vv, wu, wv, ww;
  };
  static Factor factor(const float* tensor, std::size_t stride);

  const MannBox& box_;
  int ny_;
  int nz_;
  std::size_t points_;
  std::vector<float> values_;
  std::vector<Factor> factors_;  // of the cells
  std::vector<Complex> field_;   // as the noise
  std::vector<Complex> line_;
  std::vector<Complex> column_;
  std::vector<Complex> plane_;
  Eigen::FFT<float> fft_;
};

}  // namespace lac::sim
