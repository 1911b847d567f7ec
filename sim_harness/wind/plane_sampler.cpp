// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/plane_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "sim_harness/wind/fast_length.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr double kGaps[] = {0.125, 0.25, 0.5, 1.0};

/// Of a torus, all round and in all: what an elongated grid with fine steps would need more of.
constexpr double kMostRound = 1e6;
constexpr double kMostPoints = 1e8;

int torus_points(double period_m, double step_m) {
  require(period_m / step_m <= kMostRound, "Kaimal field",
          "points round the torus of the coherence", period_m / step_m,
          "at most 1e6: steps less fine, or a grid less elongated");
  return fast_even_length(static_cast<int>(std::ceil(period_m / step_m - 1e-9)));
}

/// exp(-c r) brought to a constant at a finite distance; the constant apart.
struct CutOff {
  double rate_per_m;
  double from_m;  // where the parabola begins
  double to_m;
  double constant;
  double curvature;  // b

  CutOff(double rate, double diagonal_m)
      : rate_per_m(rate),
        from_m(diagonal_m),
        to_m(diagonal_m + std::min(diagonal_m, 2.0 / rate)),
        constant(std::exp(-rate * from_m) * (1.0 - 0.5 * rate * (to_m - from_m))),
        curvature(0.5 * rate * std::exp(-rate * from_m) / (to_m - from_m)) {}

  double operator()(double y_m, double z_m) const {
    const double r2 = y_m * y_m + z_m * z_m;
    if (r2 >= to_m * to_m) return 0.0;
    const double r_m = std::sqrt(r2);
    if (r_m <= from_m) return std::exp(-rate_per_m * r_m) - constant;
    return curvature * (to_m - r_m) * (to_m - r_m);
  }
};

}  // namespace

TorusSampler::TorusSampler(const PlaneGrid& grid, double period_y_m, double period_z_m)
    : grid_(grid),
      torus_y_(sim::torus_points(period_y_m, grid.dy_m)),
      torus_z_(sim::torus_points(period_z_m, grid.dz_m)) {
  const double points = static_cast<double>(torus_y_) * torus_z_;
  require(points <= kMostPoints, "Kaimal field", "points of the torus of the coherence", points,
          "at most 1e8: fewer points, or a grid less elongated");
  quadrant_.resize(static_cast<std::size_t>(torus_y_ / 2 + 1) * (torus_z_ / 2 + 1));
  columns_.resize(static_cast<std::size_t>(grid_.ny) * torus_z_);
  line_in_.resize(std::max(torus_y_, torus_z_));
  line_out_.resize(line_in_.size());
  fft_.SetFlag(Eigen::FFT<double>::Unscaled);
}

/// Fourier transforms, in place, of lines of the quadrant continued evenly round the torus. They
/// are real, so two go at a time.
void TorusSampler::transform_even(int lines, int line_stride, int count, int stride, int torus) {
  for (int line = 0; line < lines; line += 2) {
    double* a = &quadrant_[line * line_stride];
    double* b = line + 1 < lines ? a + line_stride : a;
    for (int i = 0; i < count; ++i) line_in_[i] = {a[i * stride], b[i * stride]};
    for (int i = count; i < torus; ++i) line_in_[i] = line_in_[torus - i];
    fft_.fwd(line_out_.data(), line_in_.data(), torus);
    for (int i = 0; i < count; ++i) b[i * stride] = line_out_[i].imag();
    for (int i = 0; i < count; ++i) a[i * stride] = line_out_[i].real();
  }
}

template <class Coherence>
double TorusSampler::embed(const Coherence& coherence) {
  const int ny = torus_y_ / 2 + 1, nz = torus_z_ / 2 + 1;
  for (int jz = 0; jz < nz; ++jz) {
    for (int iy = 0; iy < ny; ++iy)
      quadrant_[jz * ny + iy] = coherence(iy * grid_.dy_m, jz * grid_.dz_m);
  }
  transform_even(nz, ny, ny, 1, torus_y_);
  transform_even(ny, 1, nz, ny, torus_z_);
  const double scale = 1.0 / (torus_y_ * torus_z_);
  double negative = 0.0;
  for (double& value : quadrant_) {
    if (value < 0.0) negative -= 4.0 * scale * value;  // at most four points share an eigenvalue
    value = std::sqrt(std::max(value, 0.0) * scale);
  }
  return negative;
}

void TorusSampler::sample(ComplexNormal& noise, std::span<Complex> amplitudes) {
  const int half = torus_y_ / 2;
  for (int jz = 0; jz < torus_z_; ++jz) {
    const double* row = &quadrant_[std::min(jz, torus_z_ - jz) * (half + 1)];
    for (int iy = 0; iy <= half; ++iy) line_in_[iy] = row[iy] * noise();
    for (int iy = half + 1; iy < torus_y_; ++iy) line_in_[iy] = row[torus_y_ - iy] * noise();
    fft_.fwd(line_out_.data(), line_in_.data(), torus_y_);
    for (int iy = 0; iy < grid_.ny; ++iy) columns_[iy * torus_z_ + jz] = line_out_[iy];
  }
  for (int iy = 0; iy < grid_.ny; ++iy) {
    fft_.fwd(line_out_.data(), &columns_[iy * torus_z_], torus_z_);
    for (int iz = 0; iz < grid_.nz; ++iz) amplitudes[iz * grid_.ny + iy] = line_out_[iz];
  }
}

double TorusSampler::coherence(int iy, int jz) const {
  const int ny = torus_y_ / 2 + 1, nz = torus_z_ / 2 + 1;
  const auto wave = [](int k, int i, int torus) {
    const int twins = k == 0 || 2 * k == torus ? 1 : 2;
    return twins * std::cos(2.0 * kPi * k * i / torus);
  };
  double sum = 0.0;
  for (int kz = 0; kz < nz; ++kz) {
    for (int ky = 0; ky < ny; ++ky) {
      const double root = quadrant_[kz * ny + ky];
      sum += root * root * wave(ky, iy, torus_y_) * wave(kz, jz, torus_z_);
    }
  }
  return sum;
}

ShortestWaySampler::ShortestWaySampler(const PlaneGrid& grid, double gap)
    : TorusSampler(grid, (1.0 + gap) * grid.width_m(), (1.0 + gap) * grid.height_m()) {
  const auto gap_m = [](double period_m, double width_m) {
    return period_m > (2.0 - 1e-9) * width_m ? std::numeric_limits<double>::infinity()
                                             : period_m - width_m;
  };
  gap_m_ = std::min(gap_m(period_y_m(), grid.width_m()), gap_m(period_z_m(), grid.height_m()));
}

double ShortestWaySampler::prepare(double coherence_rate_per_m) {
  const double across_gap = std::exp(-coherence_rate_per_m * gap_m_);
  if (across_gap > kCoherenceTolerance) return across_gap;
  return across_gap + embed([=](double y_m, double z_m) {
           return std::exp(-coherence_rate_per_m * std::sqrt(y_m * y_m + z_m * z_m));
         });
}

CutOffSampler::CutOffSampler(const PlaneGrid& grid)
    : TorusSampler(grid, grid.width_m() + 2.0 * std::hypot(grid.width_m(), grid.height_m()),
                   grid.height_m() + 2.0 * std::hypot(grid.width_m(), grid.height_m())),
      diagonal_m_(std::hypot(grid.width_m(), grid.height_m())) {}

/// The period is shorter than twice the reach: the images of the torus overlap beyond the grid.
double CutOffSampler::prepare(double coherence_rate_per_m) {
  const CutOff f(coherence_rate_per_m, diagonal_m_);
  return embed([&](double y_m, double z_m) {
    const double image_y_m = period_y_m() - y_m, image_z_m = period_z_m() - z_m;
    return f.constant + f(y_m, z_m) + f(image_y_m, z_m) + f(y_m, image_z_m) +
           f(image_y_m, image_z_m);
  });
}

CheapestSampler::CheapestSampler(const PlaneGrid& grid) {
  for (const double gap : kGaps)
    samplers_.push_back(std::make_unique<ShortestWaySampler>(grid, gap));
  samplers_.push_back(std::make_unique<CutOffSampler>(grid));
}

bool CheapestSampler::prepare(double coherence_rate_per_m) {
  for (const auto& sampler : samplers_) {
    chosen_ = sampler.get();
    coherence_error_ = chosen_->prepare(coherence_rate_per_m);
    if (coherence_error_ <= kCoherenceTolerance) return true;
  }
  return false;
}

}  // namespace lac::sim
