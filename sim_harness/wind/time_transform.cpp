// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/time_transform.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "sim_harness/wind/parallel_jobs.hpp"

namespace lac::sim {
namespace {

constexpr int kBlock = 16;    // points transformed together: they share cache lines
constexpr int kPadding = 16;  // between lines, so that powers of 2 do not share cache sets

/// One block of neighbouring points.
class BlockWorker {
 public:
  BlockWorker(VelocityGrid& grid, std::span<const float> mean_u_mps)
      : grid_(grid),
        mean_u_mps_(mean_u_mps),
        half_(grid.spec().nt / 2 + 1 + kPadding),
        whole_(grid.spec().nt + kPadding),
        lines_(3 * kBlock * half_),
        series_(3 * kBlock * whole_) {
    fft_.SetFlag(Eigen::FFT<float>::Unscaled);
    fft_.SetFlag(Eigen::FFT<float>::HalfSpectrum);
  }

  void operator()(int job) {
    const GridSpec& g = grid_.spec();
    const std::size_t first = static_cast<std::size_t>(job) * kBlock;
    const int count = 3 * static_cast<int>(std::min<std::size_t>(kBlock, g.plane_points() - first));
    gather(3 * first, count);
    for (int i = 0; i < count; ++i) fft_.inv(&series_[i * whole_], &lines_[i * half_], g.nt);
    std::array<float, 3 * kBlock> mean{};
    for (int i = 0; i < count; i += 3) mean[i] = mean_u_mps_[(first + i / 3) / g.ny];
    for (int it = 0; it < g.nt; ++it) {
      float* to = grid_.plane(it).data() + 3 * first;
      for (int i = 0; i < count; ++i) to[i] = series_[i * whole_ + it] + mean[i];
    }
  }

 private:
  void gather(std::size_t first, int count) {
    const int nt = grid_.spec().nt;
    for (int m = 1; m <= nt / 2; ++m) {
      const float* real = grid_.plane(2 * m - 1).data() + first;
      const float* imaginary = 2 * m < nt ? grid_.plane(2 * m).data() + first : nullptr;
      for (int i = 0; i < count; ++i)
        lines_[i * half_ + m] = {real[i], imaginary != nullptr ? imaginary[i] : 0.0F};
    }
  }

  VelocityGrid& grid_;
  std::span<const float> mean_u_mps_;
  std::size_t half_;  // numbers from one line to the next
  std::size_t whole_;
  std::vector<std::complex<float>> lines_;
  std::vector<float> series_;
  Eigen::FFT<float> fft_;
};

}  // namespace

void amplitudes_to_series(VelocityGrid& grid, std::span<const float> mean_u_mps, int threads) {
  const int points = static_cast<int>(grid.spec().plane_points());
  for_each_job((points + kBlock - 1) / kBlock, threads,
               [&] { return BlockWorker(grid, mean_u_mps); });
}

}  // namespace lac::sim
