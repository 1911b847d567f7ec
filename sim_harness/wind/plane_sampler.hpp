// SPDX-License-Identifier: Apache-2.0
// Complex normal amplitudes on a y-z grid with the root coherence exp(-c r) between any two
// points r apart (methods section 15). One sampler per thread.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <span>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "sim_harness/wind/complex_normal.hpp"

namespace lac::sim {

struct PlaneGrid {
  int ny = 0;
  int nz = 0;
  double dy_m = 0.0;
  double dz_m = 0.0;

  int points() const { return ny * nz; }
};

class PlaneSampler {
 public:
  virtual ~PlaneSampler() = default;

  /// Makes ready for exp(-c r), c [1/m] > 0. False: this sampler cannot reproduce it exactly.
  virtual bool prepare(double coherence_rate_per_m) = 0;
  /// Draws ny nz amplitudes, [z][y], each with E|a|^2 = 1. Only after prepare() gave true.
  virtual void sample(ComplexNormal& noise, std::span<std::complex<double>> amplitudes) = 0;
};

/// Lower factor of the coherence matrix times noise. Cost n^3 / 3 per prepare().
class CholeskySampler final : public PlaneSampler {
 public:
  explicit CholeskySampler(const PlaneGrid& grid) : grid_(grid) {}
  bool prepare(double coherence_rate_per_m) override;
  void sample(ComplexNormal& noise, std::span<std::complex<double>> amplitudes) override;

 private:
  PlaneGrid grid_;
  Eigen::MatrixXd factor_;
  Eigen::MatrixX2d white_;
};

/// Circulant embedding: coherence over the shortest way round a torus `stretch` times as large as
/// the smallest that holds the grid, and noise times the square roots of its eigenvalues (its 2-D
/// Fourier transform). Exact where no eigenvalue is below zero; prepare() looks at all of them.
class EmbeddingSampler final : public PlaneSampler {
 public:
  EmbeddingSampler(const PlaneGrid& grid, int stretch);
  bool prepare(double coherence_rate_per_m) override;
  void sample(ComplexNormal& noise, std::span<std::complex<double>> amplitudes) override;

  int torus_points() const { return torus_y_ * torus_z_; }

 private:
  using Complex = std::complex<double>;
  double& quadrant(int jz, int iy) { return quadrant_[jz * (torus_y_ / 2 + 1) + iy]; }
  void transform_even(int count, int start, int stride, int torus);

  PlaneGrid grid_;
  int torus_y_;
  int torus_z_;
  std::vector<double> distance_m_;  // of the quadrant, which determines the torus by symmetry
  std::vector<double> quadrant_;    // coherence, then eigenvalues, then sqrt(eigenvalue / points)
  std::vector<Complex> columns_;
  std::vector<Complex> line_in_;
  std::vector<Complex> line_out_;
  Eigen::FFT<double> fft_;
};

/// Takes at each prepare() the cheapest sampler that is exact: embedding on growing tori as long
/// as that costs less than a Cholesky factor, then Cholesky.
class CheapestSampler final : public PlaneSampler {
 public:
  explicit CheapestSampler(const PlaneGrid& grid);
  bool prepare(double coherence_rate_per_m) override;
  void sample(ComplexNormal& noise, std::span<std::complex<double>> amplitudes) override;

 private:
  std::vector<std::unique_ptr<PlaneSampler>> samplers_;
  PlaneSampler* chosen_ = nullptr;
};

}  // namespace lac::sim
