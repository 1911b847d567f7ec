// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/mann_row.hpp"

#include <algorithm>
#include <cmath>

namespace lac::sim {
namespace {

constexpr float kSingular = 1e-7F;  // of the energy of a cell: rounding, not variance

}  // namespace

MannRow::Factor MannRow::factor(const float* tensor, std::size_t stride) {
  const float tuu = tensor[kUu * stride], tvv = tensor[kVv * stride], tww = tensor[kWw * stride];
  const float tuv = tensor[kUv * stride], tuw = tensor[kUw * stride], tvw = tensor[kVw * stride];
  const float least = kSingular * (tuu + tvv + tww);
  Factor f;
  f.uu = tuu > least ? std::sqrt(tuu) : 0.0F;
  const float inverse_uu = tuu > least ? 1.0F / f.uu : 0.0F;
  f.vu = tuv * inverse_uu;
  f.wu = tuw * inverse_uu;
  const float rest_v = tvv - f.vu * f.vu;
  f.vv = rest_v > least ? std::sqrt(rest_v) : 0.0F;
  f.wv = rest_v > least ? (tvw - f.vu * f.wu) / f.vv : 0.0F;
  const float rest_w = tww - f.wu * f.wu - f.wv * f.wv;
  f.ww = rest_w > least ? std::sqrt(rest_w) : 0.0F;
  return f;
}

MannRow::MannRow(const MannBox& box)
    : box_(box),
      ny_(box.spec().ny),
      nz_(box.spec().nz),
      points_(static_cast<std::size_t>(ny_) * nz_),
      values_(box.quantities() * box.cells()),
      factors_(box.cells()),
      field_(noise_size()),
      line_(std::max(ny_, nz_)),
      column_(nz_) {}

void MannRow::select(double k1_radpm) {
  box_.row(k1_radpm, values_);
  for (std::size_t cell = 0; cell < factors_.size(); ++cell)
    factors_[cell] = factor(values_.data() + cell, box_.cells());
}

void MannRow::draw(ComplexNormal& normal, std::span<Complex> noise) {
  for (Complex& n : noise) n = Complex(normal());
}

void MannRow::evolve(double lead_s, ComplexNormal& normal, std::span<Complex> noise) const {
  const auto lead = static_cast<float>(lead_s);
  const float* time_s = values_.data() + kTensorSize * box_.cells();
  for (int j3 = 0; j3 < nz_; ++j3, time_s += ny_ / 2 + 1) {
    for (int j2 = 0; j2 < ny_; ++j2) {
      const float rho = std::exp(-lead / time_s[std::min(j2, ny_ - j2)]);
      const float fresh = std::sqrt(1.0F - rho * rho);
      for (int c = 0; c < 3; ++c) {
        Complex& n = noise[c * points_ + j3 * ny_ + j2];
        n = rho * n + fresh * Complex(normal());
      }
    }
  }
}

void MannRow::colour(std::span<const Complex> noise) {
  const auto put = [&](const Factor& f, float sign_of_k2, std::size_t i) {
    const Complex a = noise[i], b = noise[points_ + i], c = noise[2 * points_ + i];
    field_[i] = f.uu * a;
    field_[points_ + i] = sign_of_k2 * f.vu * a + f.vv * b;
    field_[2 * points_ + i] = f.wu * a + sign_of_k2 * f.wv * b + f.ww * c;
  };
  std::size_t cell = 0;
  for (int j3 = 0; j3 < nz_; ++j3) {
    const std::size_t first = static_cast<std::size_t>(j3) * ny_;
    for (int j2 = 0; j2 <= ny_ / 2; ++j2, ++cell) {
      put(factors_[cell], 1.0F, first + j2);
      if (j2 != 0 && 2 * j2 != ny_) put(factors_[cell], -1.0F, first + ny_ - j2);
    }
  }
}

std::span<const MannRow::Complex> MannRow::transform(int component, int ny, int nz, float scale) {
  Complex* field = field_.data() + component * points_;
  for (int j3 = 0; j3 < nz_; ++j3) {
    fft_.fwd(line_.data(), field + j3 * ny_, ny_);
    std::copy_n(line_.data(), ny, field + j3 * ny_);
  }
  plane_.resize(static_cast<std::size_t>(ny) * nz);
  for (int iy = 0; iy < ny; ++iy) {
    for (int j3 = 0; j3 < nz_; ++j3) column_[j3] = field[j3 * ny_ + iy];
    fft_.fwd(line_.data(), column_.data(), nz_);
    for (int iz = 0; iz < nz; ++iz) plane_[iz * ny + iy] = scale * line_[iz];
  }
  return plane_;
}

}  // namespace lac::sim
