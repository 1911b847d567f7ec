// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/mann_field.hpp"

#include <cmath>
#include <string>

#include "core/units.hpp"
#include "sim_harness/wind/complex_normal.hpp"
#include "sim_harness/wind/fast_length.hpp"
#include "sim_harness/wind/mann_row.hpp"
#include "sim_harness/wind/parallel_jobs.hpp"
#include "sim_harness/wind/parameter_check.hpp"
#include "sim_harness/wind/time_transform.hpp"

namespace lac::sim {
namespace {

using Complex = std::complex<float>;

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
  require(p.ny >= 2, kWhere, "ny", p.ny, "at least 2");
  require(p.nz >= 2, kWhere, "nz", p.nz, "at least 2");
  require_positive(kWhere, "width_m", p.width_m);
  require_positive(kWhere, "height_m", p.height_m);
  require_positive(kWhere, "dt_s", p.dt_s);
  require_positive(kWhere, "duration_s", p.duration_s);
  require_positive(kWhere, "mean_speed_mps", p.mean_speed_mps);
  const double steps = p.duration_s / p.dt_s;
  require(std::abs(steps - std::round(steps)) < 1e-6 * steps, kWhere, "duration_s", p.duration_s,
          "a whole number of steps dt_s");
  require(steps > 7.5 && steps < 1e8, kWhere, "duration_s / dt_s", steps, "from 8 to 1e8");
  require(std::isfinite(p.shear_exponent) && p.shear_exponent >= 0.0, kWhere, "shear_exponent",
          p.shear_exponent, "0 or a finite number above");
  require(p.threads >= 1, kWhere, "threads", p.threads, "at least 1");
  p.box_ny = box_points(p.box_ny, p.ny);
  p.box_nz = box_points(p.box_nz, p.nz);
  check_box("box_ny", p.box_ny, p.ny);
  check_box("box_nz", p.box_nz, p.nz);
  return p;
}

int steps_of(const MannFieldParams& p) {
  return static_cast<int>(std::lround(p.duration_s / p.dt_s));
}

MannBoxSpec box_spec(const MannFieldParams& p) {
  MannBoxSpec spec;
  spec.ny = p.box_ny;
  spec.nz = p.box_nz;
  spec.dy_m = p.width_m / (p.ny - 1);
  spec.dz_m = p.height_m / (p.nz - 1);
  spec.k1_min_radpm = 2.0 * kPi / (p.duration_s * p.mean_speed_mps);
  spec.k1_max_radpm = spec.k1_min_radpm * (steps_of(p) / 2);
  spec.small_eddies = p.small_eddies;
  spec.threads = p.threads;
  return spec;
}

std::vector<float> mean_profile(const MannFieldParams& p, const GridSpec& grid) {
  std::vector<float> mean;
  for (int iz = 0; iz < grid.nz; ++iz) {
    const double profile = std::pow(grid.z_m(iz) / p.hub_height_m, p.shear_exponent);
    mean.push_back(static_cast<float>(p.mean_speed_mps * profile));
  }
  return mean;
}

}  // namespace

/// One k1 of one plane.
class MannPlanes::RowWorker {
 public:
  RowWorker(MannPlanes& planes, VelocityGrid& grid)
      : planes_(planes),
        grid_(grid),
        row_(planes.box_),
        own_noise_(planes.noise_.empty() ? row_.noise_size() : 0) {}

  void operator()(int job) {
    const int m = job + 1;
    const bool frozen = planes_.noise_.empty();
    const std::span<Complex> noise =
        frozen ? own_noise_
               : std::span(planes_.noise_).subspan(job * row_.noise_size(), row_.noise_size());
    const int plane = frozen ? 0 : planes_.planes_;
    ComplexNormal normal(planes_.params_.seed, plane, m);
    row_.select(planes_.k1_radpm(m));
    if (plane == 0) {
      row_.draw(normal, noise);
    } else {
      row_.evolve(planes_.lead_s_, normal, noise);
    }
    row_.colour(noise);
    for (int c = 0; c < 3; ++c) put(c, m);
  }

 private:
  /// Into the time steps where amplitudes_to_series() looks for it. The one at the Nyquist
  /// wavenumber is real and stands for both signs.
  void put(int component, int m) {
    const GridSpec& g = grid_.spec();
    const std::span<const Complex> amplitudes = row_.transform(component, g.ny, g.nz);
    const bool nyquist = 2 * m == g.nt;
    const float scale = planes_.scale_[component] * (nyquist ? std::sqrt(2.0F) : 1.0F);
    float* real = grid_.plane(2 * m - 1).data() + component;
    for (std::size_t i = 0; i < amplitudes.size(); ++i) real[3 * i] = scale * amplitudes[i].real();
    if (nyquist) return;
    float* imaginary = grid_.plane(2 * m).data() + component;
    for (std::size_t i = 0; i < amplitudes.size(); ++i)
      imaginary[3 * i] = scale * amplitudes[i].imag();
  }

  MannPlanes& planes_;
  VelocityGrid& grid_;
  MannRow row_;
  std::vector<Complex> own_noise_;  // where it need not be kept
};

MannPlanes::MannPlanes(const MannFieldParams& params)
    : params_(completed(params)), box_(MannTensor(params_.model), box_spec(params_)) {
  grid_spec().check();
  scale_.fill(static_cast<float>(std::sqrt(k1_radpm(1))));
  if (params_.rescale) {
    const MannVariance v = variance();
    for (int c = 0; c < 3; ++c) scale_[c] *= static_cast<float>(std::sqrt(v.tensor[c] / v.box[c]));
  }
  if (std::isfinite(params_.model.evolution_s))
    noise_.resize(static_cast<std::size_t>(steps_of(params_) / 2) * 3 * params_.box_ny *
                  params_.box_nz);
}

double MannPlanes::k1_radpm(int m) const {
  return m * box_.spec().k1_min_radpm;
}

GridSpec MannPlanes::grid_spec() const {
  GridSpec spec;
  spec.ny = params_.ny;
  spec.nz = params_.nz;
  spec.nt = steps_of(params_);
  spec.dy_m = box_.spec().dy_m;
  spec.dz_m = box_.spec().dz_m;
  spec.dt_s = params_.dt_s;
  spec.z_bottom_m = params_.hub_height_m - 0.5 * params_.height_m;
  spec.hub_height_m = params_.hub_height_m;
  spec.mean_speed_mps = params_.mean_speed_mps;
  spec.periodic = true;
  return spec;
}

MannVariance MannPlanes::variance() const {
  MannVariance variance{MannTensor(params_.model).covariance(), {}};
  const int nt = steps_of(params_);
  for (int m = 1; m <= nt / 2; ++m) {
    const SpectralTensor f = box_.spectra(k1_radpm(m));
    const double sides = 2 * m == nt ? 1.0 : 2.0;
    for (int q = 0; q < kTensorSize; ++q) variance.box[q] += sides * f[q] * k1_radpm(1);
  }
  return variance;
}

GriddedWind MannPlanes::next(double distance_m) {
  require(planes_ == 0 ? distance_m == 0.0 : std::isfinite(distance_m) && distance_m > distance_m_,
          kWhere, "distance of a plane [m]", distance_m,
          planes_ == 0 ? "0 for the first" : "more than that of the plane before it");
  lead_s_ = (distance_m - distance_m_) / params_.mean_speed_mps;
  VelocityGrid grid(grid_spec());
  for_each_job(grid.spec().nt / 2, params_.threads, [&] { return RowWorker(*this, grid); });
  amplitudes_to_series(grid, mean_profile(params_, grid.spec()), params_.threads);
  distance_m_ = distance_m;
  ++planes_;
  return GriddedWind(std::move(grid));
}

void MannPlanes::restart(std::uint64_t seed) {
  params_.seed = seed;
  planes_ = 0;
  distance_m_ = 0.0;
}

GriddedWind make_mann_field(const MannFieldParams& params) {
  MannFieldParams frozen = params;
  frozen.model.evolution_s = std::numeric_limits<double>::infinity();
  return MannPlanes(frozen).next(0.0);
}

EvolvingWind make_evolving_mann_field(const MannFieldParams& params,
                                      std::span<const double> distances_m) {
  MannPlanes planes(params);
  std::vector<WindPlane> all;
  all.push_back({0.0, planes.next(0.0)});
  for (const double distance_m : distances_m) all.push_back({distance_m, planes.next(distance_m)});
  return EvolvingWind(std::move(all));
}

}  // namespace lac::sim
