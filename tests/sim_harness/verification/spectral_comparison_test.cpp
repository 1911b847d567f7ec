// SPDX-License-Identifier: Apache-2.0
// The limits themselves: amplitudes drawn from the theory they are compared with.
#include "tests/sim_harness/verification/spectral_comparison.hpp"

#include <gtest/gtest.h>

#include "sim_harness/wind/complex_normal.hpp"

namespace lac::sim {
namespace {

constexpr std::size_t kBins = 120;
constexpr int kRealisations = 10;
const std::complex<double> kCoherence = std::polar(0.7, 0.4);

/// Density 3 of a, 2 of b, at every bin.
PairComparison drawn(std::uint64_t seed) {
  PairComparison comparison(
      std::vector<PairDensity>(kBins, {3.0, 2.0, std::sqrt(6.0) * kCoherence}), 0.01);
  ComplexNormal normal(seed, 0, 0);
  for (int i = 0; i < kRealisations; ++i) {
    std::vector<std::complex<double>> a, b;
    for (std::size_t k = 0; k < kBins; ++k) {
      const std::complex<double> common = normal(), own = normal();
      a.push_back(std::sqrt(3.0) * common);
      b.push_back(std::sqrt(2.0) *
                  (std::conj(kCoherence) * common + std::sqrt(1.0 - std::norm(kCoherence)) * own));
    }
    comparison.add(a, b);
  }
  return comparison;
}

// 95 % of power, coherence and transfer function are inside. Over 4000 values, of which the
// coherence and transfer function of a band go together, the share scatters by 0.5 %.
TEST(SpectralComparison, Limits) {
  std::vector<int> inside(4, 0);
  int values = 0, variances = 0;
  constexpr int kRepetitions = 400;
  for (int seed = 1; seed <= kRepetitions; ++seed) {
    const PairComparison c = drawn(seed);
    const std::vector<std::vector<ComparedBand>> all{c.power_a(), c.power_b(), c.coherence(),
                                                     c.transfer()};
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const ComparedBand& band : all[i]) inside[i] += band.inside();
    }
    values += static_cast<int>(all[0].size());
    variances += c.variance_a().inside();
  }
  EXPECT_GE(values, 4000);
  for (const int count : inside) EXPECT_NEAR(static_cast<double>(count) / values, 0.95, 0.015);
  EXPECT_NEAR(static_cast<double>(variances) / kRepetitions, 0.95, 0.035);
}

// The expected coherence and a crossing without bias.
TEST(SpectralComparison, HalfCoherence) {
  std::vector<ComparedBand> bands;
  for (const double f_hz : {0.01, 0.02, 0.04, 0.08, 0.16}) {
    const auto root = [](double f) {
      return std::tanh(std::atanh(std::sqrt(0.5)) - 0.5 * std::log(f / 0.04));
    };
    bands.push_back({f_hz, root(f_hz), root(f_hz / 1.1), root(f_hz) - 0.1, root(f_hz) + 0.1});
  }
  EXPECT_NEAR(half_coherence_ratio(bands), 1.1, 1e-9);
}

}  // namespace
}  // namespace lac::sim
