// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/mann_source.hpp"

#include <cmath>

#include "core/units.hpp"
#include "sim_harness/wind/fast_length.hpp"
#include "sim_harness/wind/field_grid.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "Mann field";
constexpr double kBoxFactor = 2.5;  // of the points wanted

int box_points(int asked, int wanted) {
  return asked != 0 ? asked : fast_even_length(static_cast<int>(std::ceil(kBoxFactor * wanted)));
}

void check_box(const char* name, int box, int wanted) {
  require(box % 2 == 0 && box >= wanted, kWhere, name, box,
          "0, or an even number from the points wanted");
}

/// Checks, and fills in the size of the box.
MannFieldParams completed(MannFieldParams p) {
  check_field_grid(kWhere, p);
  p.box_ny = box_points(p.box_ny, p.ny);
  p.box_nz = box_points(p.box_nz, p.nz);
  check_box("box_ny", p.box_ny, p.ny);
  check_box("box_nz", p.box_nz, p.nz);
  return p;
}

MannBoxSpec box_spec(const MannFieldParams& p, const GridSpec& grid) {
  MannBoxSpec spec;
  spec.ny = p.box_ny;
  spec.nz = p.box_nz;
  spec.dy_m = grid.dy_m;
  spec.dz_m = grid.dz_m;
  spec.k1_min_radpm = 2.0 * kPi / (p.duration_s * p.mean_speed_mps);
  spec.k1_max_radpm = spec.k1_min_radpm * (grid.nt / 2);
  spec.small_eddies = p.small_eddies;
  spec.threads = p.threads;
  return spec;
}

}  // namespace

MannSource::MannSource(const MannFieldParams& params)
    : params_(completed(params)),
      grid_(field_grid(params_)),
      box_(MannTensor(params_.model), box_spec(params_, grid_)),
      mean_mps_(mean_profile(grid_, params_.shear_exponent)) {
  scale_.fill(static_cast<float>(std::sqrt(k1_radpm(1))));
  if (!params_.rescale) return;
  const MannVariance v = variance();
  for (int c = 0; c < 3; ++c) scale_[c] *= static_cast<float>(std::sqrt(v.tensor[c] / v.box[c]));
}

MannVariance MannSource::variance() const {
  MannVariance variance{MannTensor(params_.model).covariance(), {}};
  for (int m = 1; m <= harmonics(); ++m) {
    const SpectralTensor f = box_.spectra(k1_radpm(m));
    const double sides = 2 * m == grid_.nt ? 1.0 : 2.0;
    for (int q = 0; q < kTensorSize; ++q) variance.box[q] += sides * f[q] * k1_radpm(1);
  }
  return variance;
}

float MannSource::scale(int component, int m) const {
  return scale_[component] * (2 * m == grid_.nt ? std::sqrt(2.0F) : 1.0F);
}

}  // namespace lac::sim
