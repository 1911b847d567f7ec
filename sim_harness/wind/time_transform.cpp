// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/time_transform.hpp"

#include <algorithm>
#include <array>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "sim_harness/wind/parallel_jobs.hpp"

namespace lac::sim {
namespace {

using Complex = std::complex<float>;

constexpr int kBlock = 16;    // points transformed together: they share cache lines
constexpr int kPadding = 16;  // between lines, so that powers of 2 do not share cache sets

/// Neighbouring points: `count` numbers in each time step, `step` numbers from one to the next.
struct Series {
  float* first;
  std::size_t step;
  int count;
};

class SeriesWorker {
 public:
  explicit SeriesWorker(int nt, int most_numbers)
      : nt_(nt),
        half_(static_cast<std::size_t>(nt) / 2 + 1 + kPadding),
        whole_(static_cast<std::size_t>(nt) + kPadding),
        lines_(most_numbers * half_),
        series_(most_numbers * whole_) {
    fft_.SetFlag(Eigen::FFT<float>::Unscaled);
    fft_.SetFlag(Eigen::FFT<float>::HalfSpectrum);
  }

  /// mean(i) is added to number i.
  template <class Mean>
  void operator()(const Series& s, const Mean& mean) {
    gather(s);
    for (int i = 0; i < s.count; ++i) fft_.inv(&series_[i * whole_], &lines_[i * half_], nt_);
    for (int i = 0; i < s.count; ++i) mean_[i] = mean(i);
    for (int it = 0; it < nt_; ++it) {
      float* to = s.first + it * s.step;
      for (int i = 0; i < s.count; ++i) to[i] = series_[i * whole_ + it] + mean_[i];
    }
  }

 private:
  void gather(const Series& s) {
    for (int m = 1; m <= nt_ / 2; ++m) {
      const float* real = s.first + (2 * m - 1) * s.step;
      const float* imaginary = 2 * m < nt_ ? real + s.step : nullptr;
      for (int i = 0; i < s.count; ++i)
        lines_[i * half_ + m] = {real[i], imaginary != nullptr ? imaginary[i] : 0.0F};
    }
  }

  int nt_;
  std::size_t half_;  // numbers from one line to the next
  std::size_t whole_;
  std::vector<Complex> lines_;
  std::vector<float> series_;
  std::array<float, 3 * kBlock> mean_{};
  Eigen::FFT<float> fft_;
};

}  // namespace

void put_amplitudes(std::span<const Complex> amplitudes, int component, int m, VelocityGrid& grid) {
  float* real = grid.plane(2 * m - 1).data() + component;
  for (std::size_t i = 0; i < amplitudes.size(); ++i) real[3 * i] = amplitudes[i].real();
  if (2 * m == grid.spec().nt) return;
  float* imaginary = grid.plane(2 * m).data() + component;
  for (std::size_t i = 0; i < amplitudes.size(); ++i) imaginary[3 * i] = amplitudes[i].imag();
}

void put_amplitudes(std::span<const Complex> amplitudes, int component, int m, ThinnedGrid& grid) {
  const std::span<const std::uint32_t> points = grid.columns().points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    float* real = grid.column(i).data() + 3 * (2 * m - 1) + component;
    real[0] = amplitudes[points[i]].real();
    if (2 * m < grid.spec().nt) real[3] = amplitudes[points[i]].imag();
  }
}

void amplitudes_to_series(VelocityGrid& grid, std::span<const float> mean_u_mps, int threads) {
  const GridSpec& g = grid.spec();
  const std::size_t points = g.plane_points();
  const auto make_worker = [&] {
    return [&, worker = SeriesWorker(g.nt, 3 * kBlock)](int job) mutable {
      const std::size_t first = static_cast<std::size_t>(job) * kBlock;
      const int count = 3 * static_cast<int>(std::min<std::size_t>(kBlock, points - first));
      worker({grid.plane(0).data() + 3 * first, 3 * points, count},
             [&](int i) { return i % 3 == 0 ? mean_u_mps[(first + i / 3) / g.ny] : 0.0F; });
    };
  };
  for_each_job(static_cast<int>((points + kBlock - 1) / kBlock), threads, make_worker);
}

void amplitudes_to_series(ThinnedGrid& grid, std::span<const float> mean_u_mps, int threads) {
  const GridSpec& g = grid.spec();
  const auto make_worker = [&] {
    return [&, worker = SeriesWorker(g.nt, 3)](int job) mutable {
      const float mean = mean_u_mps[grid.columns().points()[job] / g.ny];
      worker({grid.column(job).data(), 3, 3}, [&](int i) { return i == 0 ? mean : 0.0F; });
    };
  };
  for_each_job(static_cast<int>(grid.columns().count()), threads, make_worker);
}

}  // namespace lac::sim
