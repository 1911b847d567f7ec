// SPDX-License-Identifier: Apache-2.0
// What the tests of generated Mann fields share. Amplitudes are complex normal, so the standard
// error of a mean product of two of them is known exactly.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "core/units.hpp"
#include "sim_harness/wind/mann_field.hpp"
#include "tests/sim_harness/wind/kaimal_reference.hpp"

namespace lac::sim {

/// 6 x 5 points 14 and 12 m apart in a box of 20 x 20, 128 s at 2 Hz, 16 m/s.
inline MannFieldParams small_box() {
  MannFieldParams p;
  p.model.length_m = 35.0;
  p.mean_speed_mps = 16.0;
  p.width_m = 70.0;
  p.height_m = 48.0;
  p.ny = 6;
  p.nz = 5;
  p.box_ny = p.box_nz = 20;
  p.dt_s = 0.5;
  p.duration_s = 128.0;
  p.threads = 1;
  return p;
}

inline constexpr double kDk1 = 2.0 * kPi / (128.0 * 16.0);
constexpr struct Band { int first, last; } kBands[] = {{1, 3}, {4, 12}, {13, 40}, {41, 127}};

/// One component at a grid point of one plane.
struct Channel {
  int component, iy, iz, plane;
};
struct Pair {
  Channel a, b;
};

/// One-point spectra of the tensor at the harmonics of small_box(), computed once.
inline const std::vector<SpectralTensor>& harmonics() {
  static const std::vector<SpectralTensor> spectra = [] {
    const MannTensor phi(small_box().model);
    std::vector<SpectralTensor> f(128);
    for (int m = 1; m < 128; ++m) f[m] = phi.spectra(m * kDk1);
    return f;
  }();
  return spectra;
}

/// Means over seeds and each band of A_a conj(A_b) / (4 dk1 sqrt(F_a F_b)), F the one-point spectra
/// of the tensor, [pair][band]: coherence with its phase.
inline std::vector<std::vector<Complex>> products(const MannFieldParams& p,
                                                  const std::vector<double>& distances,
                                                  const std::vector<Pair>& pairs, int seeds) {
  const auto& f = harmonics();
  std::vector<std::vector<Complex>> mean(pairs.size(), std::vector<Complex>(std::size(kBands)));
  MannPlanes planes(p);
  for (int seed = 1; seed <= seeds; ++seed) {
    planes.restart(seed);
    std::vector<GriddedWind> winds{planes.next(0.0)};
    for (const double distance_m : distances) winds.push_back(planes.next(distance_m));
    const auto amplitudes_of = [&](const Channel& c) {
      return amplitudes(winds[c.plane], c.iz, c.iy, c.component);
    };
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto a = amplitudes_of(pairs[k].a), b = amplitudes_of(pairs[k].b);
      for (std::size_t i = 0; i < std::size(kBands); ++i) {
        const double count = (kBands[i].last - kBands[i].first + 1.0) * seeds;
        for (int m = kBands[i].first; m <= kBands[i].last; ++m) {
          const double power = std::sqrt(f[m][pairs[k].a.component] * f[m][pairs[k].b.component]);
          mean[k][i] += a[m] * std::conj(b[m]) / (4.0 * kDk1 * power * count);
        }
      }
    }
  }
  return mean;
}

inline int tensor_index(int c1, int c2) {
  return c1 == c2 ? c1 : std::min(c1, c2) == 1 ? kVw : std::max(c1, c2) == 1 ? kUv : kUw;
}

/// What products() has in the box on average.
inline Complex expected(const MannBox& box, double speed_mps, const std::vector<double>& distances,
                        const Pair& pair, const Band& band) {
  const auto lead_s = [&](int plane) {
    return plane == 0 ? 0.0 : distances[plane - 1] / speed_mps;
  };
  const double dt_s = std::abs(lead_s(pair.a.plane) - lead_s(pair.b.plane));
  Complex sum;
  for (int m = band.first; m <= band.last; ++m) {
    const SpectralTensor& f = harmonics()[m];
    const CrossSpectra cross =
        box.cross_spectra(m * kDk1, pair.b.iy - pair.a.iy, pair.b.iz - pair.a.iz, dt_s);
    sum += cross[tensor_index(pair.a.component, pair.b.component)] /
           std::sqrt(f[pair.a.component] * f[pair.b.component]);
  }
  return sum / (band.last - band.first + 1.0);
}

/// Real and imaginary part within 4 standard errors of the box; Var <= 1 per product.
inline void expect_products(const MannFieldParams& p, const std::vector<double>& distances,
                            const std::vector<Pair>& pairs, int seeds) {
  const MannPlanes planes(p);
  const auto found = products(p, distances, pairs, seeds);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    for (std::size_t i = 0; i < std::size(kBands); ++i) {
      const Complex theory =
          expected(planes.box(), p.mean_speed_mps, distances, pairs[k], kBands[i]);
      const double count = (kBands[i].last - kBands[i].first + 1.0) * seeds;
      const double r = std::norm(theory);
      EXPECT_NEAR(found[k][i].real(), theory.real(), 4.0 * std::sqrt(0.5 * (1.0 + r) / count))
          << "pair " << k << " band " << i;
      EXPECT_NEAR(found[k][i].imag(), theory.imag(), 4.0 * std::sqrt(0.5 / count))
          << "pair " << k << " band " << i;
    }
  }
}

}  // namespace lac::sim
