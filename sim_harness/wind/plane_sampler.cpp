// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/plane_sampler.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace lac::sim {
namespace {

/// Next even length with no prime factor above 5, which the FFT is fast at.
int fast_even_length(int least) {
  for (int n = least + least % 2;; n += 2) {
    int rest = n;
    for (int prime : {2, 3, 5}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return n;
  }
}

/// Two 2-D transforms of M points against a factor of n: measured, a transform takes about
/// 40 M log2 M of the operations of which a factor takes n^3 / 3.
bool embedding_pays(int torus_points, int grid_points) {
  const double m = torus_points, n = grid_points;
  return 40.0 * m * std::log2(m) < n * n * n / 3.0;
}

}  // namespace

bool CholeskySampler::prepare(double coherence_rate_per_m) {
  const int n = grid_.points();
  factor_.resize(n, n);
  for (int column = 0; column < n; ++column) {
    for (int row = column; row < n; ++row) {
      const int dy = row % grid_.ny - column % grid_.ny, dz = row / grid_.ny - column / grid_.ny;
      const double r_m = std::hypot(dy * grid_.dy_m, dz * grid_.dz_m);
      factor_(row, column) = std::exp(-coherence_rate_per_m * r_m);
    }
  }
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(factor_);
  return in_place.info() == Eigen::Success;
}

void CholeskySampler::sample(ComplexNormal& noise, std::span<std::complex<double>> amplitudes) {
  white_.resize(grid_.points(), 2);
  for (Eigen::Index i = 0; i < white_.rows(); ++i) {
    const std::complex<double> xi = noise();
    white_.row(i) << xi.real(), xi.imag();
  }
  const Eigen::MatrixX2d coloured = factor_.triangularView<Eigen::Lower>() * white_;
  for (Eigen::Index i = 0; i < coloured.rows(); ++i)
    amplitudes[i] = {coloured(i, 0), coloured(i, 1)};
}

EmbeddingSampler::EmbeddingSampler(const PlaneGrid& grid, int stretch)
    : grid_(grid),
      torus_y_(fast_even_length(2 * (grid.ny - 1) * stretch)),
      torus_z_(fast_even_length(2 * (grid.nz - 1) * stretch)) {
  for (int jz = 0; jz <= torus_z_ / 2; ++jz) {
    for (int iy = 0; iy <= torus_y_ / 2; ++iy)
      distance_m_.push_back(std::hypot(iy * grid_.dy_m, jz * grid_.dz_m));
  }
  quadrant_.resize(distance_m_.size());
  columns_.resize(static_cast<std::size_t>(grid_.ny) * torus_z_);
  line_in_.resize(std::max(torus_y_, torus_z_));
  line_out_.resize(line_in_.size());
  fft_.SetFlag(Eigen::FFT<double>::Unscaled);
}

/// Fourier transform, in place, of a line of the quadrant continued evenly round the torus.
void EmbeddingSampler::transform_even(int count, int start, int stride, int torus) {
  for (int i = 0; i < count; ++i) line_in_[i] = quadrant_[start + i * stride];
  for (int i = count; i < torus; ++i) line_in_[i] = line_in_[torus - i];
  fft_.fwd(line_out_.data(), line_in_.data(), torus);
  for (int i = 0; i < count; ++i) quadrant_[start + i * stride] = line_out_[i].real();
}

bool EmbeddingSampler::prepare(double coherence_rate_per_m) {
  const int ny = torus_y_ / 2 + 1, nz = torus_z_ / 2 + 1;
  std::transform(distance_m_.begin(), distance_m_.end(), quadrant_.begin(),
                 [=](double r_m) { return std::exp(-coherence_rate_per_m * r_m); });
  for (int jz = 0; jz < nz; ++jz) transform_even(ny, jz * ny, 1, torus_y_);
  for (int iy = 0; iy < ny; ++iy) transform_even(nz, iy, ny, torus_z_);
  if (*std::min_element(quadrant_.begin(), quadrant_.end()) < 0.0) return false;
  const double scale = 1.0 / torus_points();
  for (double& value : quadrant_) value = std::sqrt(value * scale);
  return true;
}

void EmbeddingSampler::sample(ComplexNormal& noise, std::span<Complex> amplitudes) {
  for (int jz = 0; jz < torus_z_; ++jz) {
    const int row = std::min(jz, torus_z_ - jz);
    for (int iy = 0; iy < torus_y_; ++iy)
      line_in_[iy] = quadrant(row, std::min(iy, torus_y_ - iy)) * noise();
    fft_.fwd(line_out_.data(), line_in_.data(), torus_y_);
    for (int iy = 0; iy < grid_.ny; ++iy) columns_[iy * torus_z_ + jz] = line_out_[iy];
  }
  for (int iy = 0; iy < grid_.ny; ++iy) {
    fft_.fwd(line_out_.data(), &columns_[iy * torus_z_], torus_z_);
    for (int iz = 0; iz < grid_.nz; ++iz) amplitudes[iz * grid_.ny + iy] = line_out_[iz];
  }
}

CheapestSampler::CheapestSampler(const PlaneGrid& grid) {
  for (int stretch = 1;; stretch *= 2) {
    auto embedding = std::make_unique<EmbeddingSampler>(grid, stretch);
    if (!embedding_pays(embedding->torus_points(), grid.points())) break;
    samplers_.push_back(std::move(embedding));
  }
  samplers_.push_back(std::make_unique<CholeskySampler>(grid));
}

bool CheapestSampler::prepare(double coherence_rate_per_m) {
  for (const auto& sampler : samplers_) {
    chosen_ = sampler.get();
    if (chosen_->prepare(coherence_rate_per_m)) return true;
  }
  return false;
}

void CheapestSampler::sample(ComplexNormal& noise, std::span<std::complex<double>> amplitudes) {
  chosen_->sample(noise, amplitudes);
}

}  // namespace lac::sim
