// SPDX-License-Identifier: Apache-2.0
// Complex normal amplitudes on a y-z grid with the root coherence exp(-c r) between any two points
// r apart, by circulant embedding. One sampler per thread.
#pragma once

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
  double width_m() const { return (ny - 1) * dy_m; }
  double height_m() const { return (nz - 1) * dz_m; }
};

/// What a sampler may be off exp(-c r) by at any pair of points: single precision.
inline constexpr double kCoherenceTolerance = 1e-7;

/// The coherence as a function of the separation on a torus that is wider than the grid, and noise
/// times the square roots of its eigenvalues (its 2-D Fourier transform), which must not be below
/// zero. Cost: two 2-D transforms of the torus.
class TorusSampler {
 public:
  virtual ~TorusSampler() = default;

  /// Makes ready for exp(-c r), c [1/m] > 0. Returns an upper bound of what the coherence of any
  /// pair of points is off by: the sum of the negative eigenvalues, which are taken as zero, and
  /// what the continuation round the torus costs. Above kCoherenceTolerance: not made ready.
  virtual double prepare(double coherence_rate_per_m) = 0;
  /// Draws ny nz amplitudes, [z][y], each with E|a|^2 = 1.
  void sample(ComplexNormal& noise, std::span<std::complex<double>> amplitudes);
  /// E[a b*] of amplitudes at points iy and jz steps apart, from the eigenvalues as they are used.
  double coherence(int iy, int jz) const;

  int torus_points() const { return torus_y_ * torus_z_; }

 protected:
  using Complex = std::complex<double>;

  /// The torus has at least these periods. Throws lac::Error if it would be too large.
  TorusSampler(const PlaneGrid& grid, double period_y_m, double period_z_m);
  double period_y_m() const { return torus_y_ * grid_.dy_m; }
  double period_z_m() const { return torus_z_ * grid_.dz_m; }
  /// coherence(y, z) at separations up to half the periods. Returns the share of the negative
  /// eigenvalues.
  template <class Coherence>
  double embed(const Coherence& coherence);

 private:
  void transform_even(int lines, int line_stride, int count, int stride, int torus);

  PlaneGrid grid_;
  int torus_y_;
  int torus_z_;
  std::vector<double> quadrant_;  // coherence, then eigenvalues, then sqrt(eigenvalue / points)
  std::vector<Complex> columns_;
  std::vector<Complex> line_in_;
  std::vector<Complex> line_out_;
  Eigen::FFT<double> fft_;
};

/// exp(-c r), r the shortest way round a torus wider than the grid by gap times the grid. With gap
/// 1 the grid sees all of it right; eigenvalues are negative where c times the width of the grid is
/// below about 5.5. With less, points at opposite borders see each other across the gap with
/// exp(-c gap): for large c.
class ShortestWaySampler final : public TorusSampler {
 public:
  ShortestWaySampler(const PlaneGrid& grid, double gap);
  double prepare(double coherence_rate_per_m) override;

 private:
  double gap_m_;  // infinite where the torus has room for every separation
};

/// Cut-off embedding (Gneiting et al. 2006) with a constant: up to the diagonal r0 of the grid
/// exp(-c r), then k + b (R - r)^2, k beyond R = r0 + min(r0, 2/c); b and k make value and slope
/// continuous. Its 2-D transform depends on c r0 alone and is positive (found numerically, c r0
/// from 1e-8 to 30; R = 1.75 r0 would not do below c r0 = 0.1), so this is exact at every rate on
/// every grid. The torus: grid + 2 r0.
class CutOffSampler final : public TorusSampler {
 public:
  explicit CutOffSampler(const PlaneGrid& grid);
  double prepare(double coherence_rate_per_m) override;

 private:
  double diagonal_m_;
};

/// Takes at each prepare() the smallest torus that is right within kCoherenceTolerance.
class CheapestSampler {
 public:
  explicit CheapestSampler(const PlaneGrid& grid);
  /// False: none is, which no finite c > 0 is known to do.
  bool prepare(double coherence_rate_per_m);
  void sample(ComplexNormal& noise, std::span<std::complex<double>> amplitudes) {
    chosen_->sample(noise, amplitudes);
  }

  /// Of the last prepare(): see TorusSampler::prepare().
  double coherence_error() const { return coherence_error_; }
  int torus_points() const { return chosen_->torus_points(); }

 private:
  std::vector<std::unique_ptr<TorusSampler>> samplers_;
  TorusSampler* chosen_ = nullptr;
  double coherence_error_ = 0.0;
};

}  // namespace lac::sim
