// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/mann_theory.hpp"

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "sim_harness/wind/mann_field.hpp"
#include "sim_harness/wind_check/theory_check.hpp"

namespace lac::sim {
namespace {

constexpr double kSpeed_mps = 16.0;

// The table against the integral at frequencies between its nodes, all components: 2 per mille.
TEST(MannTheory, SpectraAreThoseOfTheTensor) {
  const MannParams params;
  const MannTheory theory(params, kSpeed_mps);
  const MannTensor tensor(params);
  const TensorIndex diagonal[] = {kUu, kVv, kWw};
  for (const double f_hz : {0.0011, 0.0123, 0.137, 1.7}) {
    const double per_hz = 2.0 * kPi / kSpeed_mps;
    const SpectralTensor f = tensor.spectra(f_hz * per_hz);
    for (int c = 0; c < 3; ++c) {
      const double expected = 2.0 * per_hz * f[diagonal[c]];
      EXPECT_NEAR(theory.spectrum(c, f_hz) / expected, 1.0, 2e-3) << c << ' ' << f_hz;
    }
  }
}

// Coherencies on a lattice against the tensor's own cross spectra, to the left and the right, up
// and down: the same integral with its sums in another order (the quadrature itself is good to
// 3e-5).
TEST(MannTheory, CoherenciesAreThoseOfTheTensor) {
  const MannParams params;
  const MannTheory theory(params, kSpeed_mps);
  const MannTensor tensor(params);
  const TensorIndex diagonal[] = {kUu, kVv, kWw};
  const Lattice lattice{4, 3, 8.0, 12.0};
  const double f_hz = 0.03, k1_radpm = 2.0 * kPi * f_hz / kSpeed_mps;
  for (int c = 0; c < 3; ++c) {
    const CoherencyTable table = theory.coherencies(c, f_hz, lattice);
    EXPECT_NEAR(std::abs(table.at(0, 0) - 1.0), 0.0, 1e-12);
    for (const auto& [y, z] : {std::pair{1, 0}, {3, 0}, {0, 2}, {-2, 1}, {1, -2}}) {
      const CrossSpectra cross = tensor.cross_spectra(k1_radpm, {8.0 * y, 12.0 * z});
      const std::complex<double> expected =
          cross[diagonal[c]] / tensor.spectra(k1_radpm)[diagonal[c]];
      EXPECT_NEAR(std::abs(table.at(y, z) - expected), 0.0, 3e-6) << c << ' ' << y << ' ' << z;
    }
  }
}

// A generated field passes with the usual allowances; a theory of 70 % of its length does not.
TEST(MannTheory, AGeneratedFieldPasses) {
  MannFieldParams p;
  p.mean_speed_mps = kSpeed_mps;
  p.ny = p.nz = 12;
  p.width_m = p.height_m = 88.0;
  p.dt_s = 0.25;
  p.duration_s = 512.0;
  p.seed = 5;
  const GriddedWind wind = make_mann_field(p);
  const CheckSettings settings{.coherence_allowance = 0.05};
  const TheoryCheck check = check_field(wind, MannTheory(p.model, kSpeed_mps), settings);
  EXPECT_EQ(check.outside, 0);
  MannParams other = p.model;
  other.length_m *= 0.7;
  EXPECT_FALSE(check_field(wind, MannTheory(other, kSpeed_mps), settings).passed());
}

}  // namespace
}  // namespace lac::sim
