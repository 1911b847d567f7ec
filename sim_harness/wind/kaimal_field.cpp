// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/kaimal_field.hpp"

#include <array>
#include <atomic>
#include <complex>
#include <future>
#include <vector>

#include "sim_harness/wind/parameter_check.hpp"
#include "sim_harness/wind/plane_sampler.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "Kaimal field";
constexpr std::array<const char*, 3> kComponentNames{"u", "v", "w"};
constexpr int kBlock = 16;  // points transformed in time together: they share cache lines

struct Component {
  int index;  // 0 u, 1 v, 2 w
  KaimalComponent spectrum;
  bool coherent;
};

/// Amplitudes A_m of one component, [frequency m - 1][point]; single precision halves the memory.
using Spectra = std::vector<std::complex<float>>;

void check(const KaimalFieldParams& p, const std::array<Component, 3>& components) {
  require_positive(kWhere, "width_m", p.width_m);
  require_positive(kWhere, "height_m", p.height_m);
  require_positive(kWhere, "dt_s", p.dt_s);
  require_positive(kWhere, "duration_s", p.duration_s);
  require_positive(kWhere, "mean_speed_mps", p.mean_speed_mps);
  const double steps = p.duration_s / p.dt_s;
  require(std::abs(steps - std::round(steps)) < 1e-6 * steps, kWhere, "duration_s", p.duration_s,
          "a whole number of steps dt_s");
  require(steps < 1e8, kWhere, "duration_s / dt_s", steps, "below 1e8");
  require(std::isfinite(p.shear_exponent) && p.shear_exponent >= 0.0, kWhere, "shear_exponent",
          p.shear_exponent, "0 or a finite number above");
  require(p.threads >= 1, kWhere, "threads", p.threads, "at least 1");
  require_positive(kWhere, "coherence_decay", p.model.coherence_decay);
  require_positive(kWhere, "coherence_length_m", p.model.coherence_length_m);
  for (const Component& c : components) {
    const std::string name = kComponentNames[c.index];
    require(std::isfinite(c.spectrum.sigma_mps) && c.spectrum.sigma_mps >= 0.0, kWhere,
            "sigma_" + name, c.spectrum.sigma_mps, "0 or a finite number above");
    require_positive(kWhere, "length scale of " + name, c.spectrum.length_scale_m);
  }
}

GridSpec grid_spec(const KaimalFieldParams& p) {
  GridSpec spec;
  spec.ny = p.ny;
  spec.nz = p.nz;
  spec.nt = static_cast<int>(std::lround(p.duration_s / p.dt_s));
  spec.dy_m = p.width_m / (p.ny - 1);
  spec.dz_m = p.height_m / (p.nz - 1);
  spec.dt_s = p.dt_s;
  spec.z_bottom_m = p.hub_height_m - 0.5 * p.height_m;
  spec.hub_height_m = p.hub_height_m;
  spec.mean_speed_mps = p.mean_speed_mps;
  spec.periodic = true;
  return spec;
}

/// Spreads count jobs over threads; each thread makes its own worker (with its work space). Which
/// thread does which job is open, so the jobs must not depend on it.
template <class MakeWorker>
void for_each_job(int count, int threads, const MakeWorker& make_worker) {
  std::atomic<int> next{0};
  const auto run = [&] {
    auto worker = make_worker();
    for (int job = next++; job < count; job = next++) worker(job);
  };
  std::vector<std::future<void>> others;
  for (int i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, run));
  run();
  for (auto& other : others) other.get();
}

/// The amplitudes of one frequency of one component.
class FrequencyWorker {
 public:
  FrequencyWorker(const KaimalFieldParams& params, const GridSpec& grid, const Component& component,
                  Spectra& spectra)
      : params_(params),
        component_(component),
        points_(grid.plane_points()),
        df_hz_(1.0 / (grid.nt * grid.dt_s)),
        sampler_({grid.ny, grid.nz, grid.dy_m, grid.dz_m}),
        amplitudes_(points_),
        spectra_(spectra) {}

  void operator()(int job) {
    const int m = job + 1;
    ComplexNormal noise(params_.seed, component_.index, m);
    draw(m * df_hz_, noise);
    const double variance = component_.spectrum.variance((m - 0.5) * df_hz_, (m + 0.5) * df_hz_,
                                                         params_.mean_speed_mps);
    const double scale = std::sqrt(2.0 * variance);
    std::complex<float>* row = spectra_.data() + job * points_;
    for (std::size_t i = 0; i < points_; ++i) row[i] = std::complex<float>(scale * amplitudes_[i]);
  }

 private:
  void draw(double frequency_hz, ComplexNormal& noise) {
    if (!component_.coherent) {
      for (auto& a : amplitudes_) a = noise();
      return;
    }
    const double rate = params_.model.coherence_rate(frequency_hz, params_.mean_speed_mps);
    require(sampler_.prepare(rate), kWhere, "coherence rate [1/m]", rate,
            "a rate at which the coherence matrix can be factored (coherence_decay is too small or "
            "coherence_length_m too large for this grid)");
    sampler_.sample(noise, amplitudes_);
  }

  const KaimalFieldParams& params_;
  const Component& component_;
  std::size_t points_;
  double df_hz_;
  CheapestSampler sampler_;
  std::vector<std::complex<double>> amplitudes_;
  Spectra& spectra_;
};

/// From amplitudes to time series for one block of neighbouring points.
class TimeWorker {
 public:
  TimeWorker(const Spectra& spectra, int component, VelocityGrid& out)
      : spectra_(spectra),
        component_(component),
        out_(out),
        half_(out.spec().nt / 2 + 1),
        lines_(static_cast<std::size_t>(half_) * kBlock),
        series_(static_cast<std::size_t>(out.spec().nt) * kBlock) {
    fft_.SetFlag(Eigen::FFT<float>::Unscaled);
    fft_.SetFlag(Eigen::FFT<float>::HalfSpectrum);
  }

  void operator()(int job) {
    const std::size_t points = out_.spec().plane_points();
    const std::size_t first = static_cast<std::size_t>(job) * kBlock;
    const int count = static_cast<int>(std::min<std::size_t>(kBlock, points - first));
    gather(first, count);
    const int nt = out_.spec().nt;
    for (int i = 0; i < count; ++i) fft_.inv(&series_[i * nt], &lines_[i * half_], nt);
    for (int it = 0; it < nt; ++it) {
      float* to = out_.plane(it).data() + first * 3 + component_;
      for (int i = 0; i < count; ++i) to[3 * i] = series_[i * nt + it];
    }
  }

 private:
  /// The inverse transform adds A_m and its conjugate, so each enters with one half; the last one
  /// of an even number of steps (Nyquist) has no partner and only its real part acts.
  void gather(std::size_t first, int count) {
    const std::size_t points = out_.spec().plane_points();
    for (int m = 1; m < half_; ++m) {
      const std::complex<float>* row = spectra_.data() + (m - 1) * points + first;
      const bool nyquist = 2 * m == out_.spec().nt;
      for (int i = 0; i < count; ++i)
        lines_[i * half_ + m] = nyquist ? std::complex<float>(row[i].real()) : 0.5F * row[i];
    }
  }

  const Spectra& spectra_;
  int component_;
  VelocityGrid& out_;
  int half_;
  std::vector<std::complex<float>> lines_;
  std::vector<float> series_;
  Eigen::FFT<float> fft_;
};

void add_mean_profile(const KaimalFieldParams& p, VelocityGrid& grid) {
  const GridSpec& g = grid.spec();
  for (int iz = 0; iz < g.nz; ++iz) {
    const double profile = std::pow(g.z_m(iz) / p.hub_height_m, p.shear_exponent);
    const float mean = static_cast<float>(p.mean_speed_mps * profile);
    for (int it = 0; it < g.nt; ++it) {
      for (int iy = 0; iy < g.ny; ++iy) grid.at(it, iz, iy, 0) += mean;
    }
  }
}

}  // namespace

GriddedWind make_kaimal_field(const KaimalFieldParams& params) {
  const bool lateral = params.lateral_coherence == LateralCoherence::kSameAsU;
  const std::array<Component, 3> components{
      {{0, params.model.u, true}, {1, params.model.v, lateral}, {2, params.model.w, lateral}}};
  check(params, components);
  VelocityGrid grid(grid_spec(params));
  const GridSpec& spec = grid.spec();
  const int points = static_cast<int>(spec.plane_points());

  Spectra spectra(static_cast<std::size_t>(spec.nt / 2) * points);
  for (const Component& component : components) {
    for_each_job(spec.nt / 2, params.threads,
                 [&] { return FrequencyWorker(params, spec, component, spectra); });
    for_each_job((points + kBlock - 1) / kBlock, params.threads,
                 [&] { return TimeWorker(spectra, component.index, grid); });
  }
  add_mean_profile(params, grid);
  return GriddedWind(std::move(grid));
}

}  // namespace lac::sim
