// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/mann_field.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <unsupported/Eigen/FFT>

#include "core/units.hpp"
#include "sim_harness/wind/complex_normal.hpp"
#include "sim_harness/wind/fast_length.hpp"
#include "sim_harness/wind/parallel_jobs.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

using Complex = std::complex<float>;

constexpr auto kWhere = "Mann field";
constexpr double kBoxFactor = 2.5;  // of the points wanted
constexpr int kBlock = 16;          // points transformed in time together: they share cache lines
constexpr int kPadding = 16;        // between lines, so that powers of 2 do not share cache sets
constexpr float kSingular = 1e-7F;  // of the energy of a cell: rounding, not variance

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

/// Lower triangular C of one cell, C C^T its tensor. An incompressible tensor is singular, so
/// pivots may be rounding alone: they are left out.
struct Factor {
  float uu, vu, vv, wu, wv, ww;

  Factor(const float* tensor, std::size_t stride) {
    const float tuu = tensor[kUu * stride], tvv = tensor[kVv * stride], tww = tensor[kWw * stride];
    const float tuv = tensor[kUv * stride], tuw = tensor[kUw * stride], tvw = tensor[kVw * stride];
    const float least = kSingular * (tuu + tvv + tww);
    uu = tuu > least ? std::sqrt(tuu) : 0.0F;
    const float inverse_uu = tuu > least ? 1.0F / uu : 0.0F;
    vu = tuv * inverse_uu;
    wu = tuw * inverse_uu;
    const float rest_v = tvv - vu * vu;
    vv = rest_v > least ? std::sqrt(rest_v) : 0.0F;
    wv = rest_v > least ? (tvw - vu * wu) / vv : 0.0F;
    const float rest_w = tww - wu * wu - wv * wv;
    ww = rest_w > least ? std::sqrt(rest_w) : 0.0F;
  }
};

}  // namespace

/// One k1 of one plane: draws, colours, transforms over y and z. In the grid the amplitude of
/// frequency m waits as real part in time step 2 m - 1 and imaginary part in 2 m.
class MannPlanes::RowWorker {
 public:
  RowWorker(MannPlanes& planes, VelocityGrid& grid)
      : planes_(planes),
        grid_(grid),
        ny_(planes.params_.box_ny),
        nz_(planes.params_.box_nz),
        points_(static_cast<std::size_t>(ny_) * nz_),
        values_(planes.box_.quantities() * planes.box_.cells()),
        noise_(planes.noise_.empty() ? 3 * points_ : 0),
        field_(3 * points_),
        line_(std::max(ny_, nz_)) {}

  void operator()(int job) {
    const int m = job + 1;
    planes_.box_.row(planes_.k1_radpm(m), values_);
    Complex* noise =
        planes_.noise_.empty() ? noise_.data() : planes_.noise_.data() + job * 3 * points_;
    draw(m, noise);
    colour(noise);
    for (int c = 0; c < 3; ++c) transform(c, m);
  }

 private:
  void draw(int m, Complex* noise) {
    const int plane = planes_.noise_.empty() ? 0 : planes_.planes_;
    ComplexNormal normal(planes_.params_.seed, plane, m);
    if (plane == 0) {
      for (std::size_t i = 0; i < 3 * points_; ++i) noise[i] = Complex(normal());
      return;
    }
    const auto lead_s = static_cast<float>(planes_.lead_s_);
    const float* time_s = values_.data() + kTensorSize * planes_.box_.cells();
    for (int j3 = 0; j3 < nz_; ++j3, time_s += ny_ / 2 + 1) {
      for (int j2 = 0; j2 < ny_; ++j2) {
        const float rho = std::exp(-lead_s / time_s[std::min(j2, ny_ - j2)]);
        const float fresh = std::sqrt(1.0F - rho * rho);
        for (int c = 0; c < 3; ++c) {
          Complex& n = noise[c * points_ + j3 * ny_ + j2];
          n = rho * n + fresh * Complex(normal());
        }
      }
    }
  }

  void colour(const Complex* noise) {
    std::size_t cell = 0;
    for (int j3 = 0; j3 < nz_; ++j3) {
      for (int j2 = 0; j2 <= ny_ / 2; ++j2, ++cell) {
        const Factor factor(values_.data() + cell, planes_.box_.cells());
        put(factor, 1.0F, noise, static_cast<std::size_t>(j3) * ny_ + j2);
        if (j2 != 0 && 2 * j2 != ny_)
          put(factor, -1.0F, noise, static_cast<std::size_t>(j3) * ny_ + ny_ - j2);
      }
    }
  }

  /// The sign is that of k2: uv and vw change with it.
  void put(const Factor& f, float sign, const Complex* noise, std::size_t i) {
    const Complex a = noise[i], b = noise[points_ + i], c = noise[2 * points_ + i];
    field_[i] = f.uu * a;
    field_[points_ + i] = sign * f.vu * a + f.vv * b;
    field_[2 * points_ + i] = f.wu * a + sign * f.wv * b + f.ww * c;
  }

  /// e^(-i (k2 y + k3 z)): with e^(i k1 U t) in time this is the conjugate of the field at
  /// x = -U t, which has the same statistics.
  void transform(int component, int m) {
    const GridSpec& g = grid_.spec();
    Complex* field = field_.data() + component * points_;
    for (int j3 = 0; j3 < nz_; ++j3) {
      fft_.fwd(line_.data(), field + j3 * ny_, ny_);
      std::copy_n(line_.data(), g.ny, field + j3 * ny_);
    }
    const bool nyquist = 2 * m == g.nt;
    const float scale = planes_.scale_[component] * (nyquist ? std::sqrt(2.0F) : 1.0F);
    float* real = grid_.plane(2 * m - 1).data() + component;
    float* imaginary = nyquist ? nullptr : grid_.plane(2 * m).data() + component;
    column_.resize(nz_);
    for (int iy = 0; iy < g.ny; ++iy) {
      for (int j3 = 0; j3 < nz_; ++j3) column_[j3] = field[j3 * ny_ + iy];
      fft_.fwd(line_.data(), column_.data(), nz_);
      for (int iz = 0; iz < g.nz; ++iz) {
        const std::size_t point = 3 * (static_cast<std::size_t>(iz) * g.ny + iy);
        real[point] = scale * line_[iz].real();
        if (!nyquist) imaginary[point] = scale * line_[iz].imag();
      }
    }
  }

  MannPlanes& planes_;
  VelocityGrid& grid_;
  int ny_;
  int nz_;
  std::size_t points_;
  std::vector<float> values_;
  std::vector<Complex> noise_;  // where it need not be kept
  std::vector<Complex> field_;  // [component][k3][k2], then [k3][y]
  std::vector<Complex> line_;
  std::vector<Complex> column_;
  Eigen::FFT<float> fft_;
};

/// From amplitudes to time series, in place, for one block of neighbouring points.
class MannPlanes::TimeWorker {
 public:
  TimeWorker(const MannFieldParams& params, VelocityGrid& grid)
      : params_(params),
        grid_(grid),
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
    for (int i = 0; i < count; i += 3) mean[i] = mean_speed((first + i / 3) / g.ny);
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
        lines_[i * half_ + m] = Complex(real[i], imaginary ? imaginary[i] : 0.0F);
    }
  }

  float mean_speed(std::size_t iz) const {
    const double height = grid_.spec().z_m(static_cast<int>(iz)) / params_.hub_height_m;
    return static_cast<float>(params_.mean_speed_mps * std::pow(height, params_.shear_exponent));
  }

  const MannFieldParams& params_;
  VelocityGrid& grid_;
  std::size_t half_;  // numbers from one line to the next
  std::size_t whole_;
  std::vector<Complex> lines_;
  std::vector<float> series_;
  Eigen::FFT<float> fft_;
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
  const int points = static_cast<int>(grid.spec().plane_points());
  for_each_job(grid.spec().nt / 2, params_.threads, [&] { return RowWorker(*this, grid); });
  for_each_job((points + kBlock - 1) / kBlock, params_.threads,
               [&] { return TimeWorker(params_, grid); });
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
