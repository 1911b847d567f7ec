// SPDX-License-Identifier: Apache-2.0
// What the tests of the generated field share: a small field, its amplitudes, and theory.
#pragma once

#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "sim_harness/wind/kaimal_field.hpp"

namespace lac::sim {

using Complex = std::complex<double>;

/// n x n points on 96 x 72 m, 128 s at 2 Hz.
inline KaimalFieldParams small_field(int n, LateralCoherence lateral) {
  KaimalFieldParams params;
  params.ny = params.nz = n;
  params.width_m = 96.0;
  params.height_m = 72.0;
  params.dt_s = 0.5;
  params.duration_s = 128.0;
  params.lateral_coherence = lateral;
  params.threads = 1;
  return params;
}

/// Amplitudes A_m of one component at one grid point, m = 0..nt/2 - 1.
inline std::vector<Complex> amplitudes(const GriddedWind& wind, int iz, int iy, int component) {
  const int nt = wind.grid().spec().nt;
  std::vector<double> series(nt);
  for (int it = 0; it < nt; ++it) series[it] = wind.grid().at(it, iz, iy, component);
  std::vector<Complex> spectrum;
  Eigen::FFT<double> fft;
  fft.fwd(spectrum, series);
  spectrum.resize(nt / 2);
  for (Complex& a : spectrum) a *= 2.0 / nt;
  return spectrum;
}

inline const KaimalComponent& component_of(const KaimalModel& model, int c) {
  return c == 0 ? model.u : c == 1 ? model.v : model.w;
}

/// Spectrum times df at frequency m / T, integrated over its bin.
inline double bin_variance(const KaimalFieldParams& p, int c, int m) {
  const double df_hz = 1.0 / p.duration_s;
  return component_of(p.model, c).variance((m - 0.5) * df_hz, (m + 0.5) * df_hz, p.mean_speed_mps);
}

inline double distance_m(const KaimalFieldParams& p, int jy, int jz) {
  return std::hypot(jy * p.width_m / (p.ny - 1), jz * p.height_m / (p.nz - 1));
}

}  // namespace lac::sim
