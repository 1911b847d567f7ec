// SPDX-License-Identifier: Apache-2.0
// Coherence of the generated field against theory over many seeds, which are fixed.
#include <gtest/gtest.h>

#include "sim_harness/wind/plane_sampler.hpp"
#include "tests/sim_harness/wind/kaimal_reference.hpp"

namespace lac::sim {
namespace {

struct Band {
  int first;
  int last;
};
/// Component c1 at the corner of the grid and c2 at the point (iy, iz).
struct Pair {
  int c1;
  int c2;
  int iy;
  int iz;
};

constexpr Band kBand{2, 9};  // 0.016 to 0.07 Hz
constexpr int kBandWidth = 8;

/// Mean over seeds and the band of A_1 A_2*, normalised with the theoretical spectra.
std::vector<Complex> coherences(KaimalFieldParams p, const std::vector<Pair>& pairs, int seeds) {
  std::vector<Complex> mean(pairs.size());
  for (p.seed = 1; p.seed <= static_cast<std::uint64_t>(seeds); ++p.seed) {
    const GriddedWind wind = make_kaimal_field(p);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto& [c1, c2, iy, iz] = pairs[k];
      const auto a = amplitudes(wind, 0, 0, c1), b = amplitudes(wind, iz, iy, c2);
      for (int m = kBand.first; m <= kBand.last; ++m) {
        const double power = std::sqrt(bin_variance(p, c1, m) * bin_variance(p, c2, m));
        mean[k] += a[m] * std::conj(b[m]) / 2.0 / power / (1.0 * seeds * kBandWidth);
      }
    }
  }
  return mean;
}

/// Theory, its mean over the band.
double band_coherence(const KaimalFieldParams& p, const Pair& pair) {
  if (pair.c1 != pair.c2) return 0.0;
  if (pair.c1 != 0 && p.lateral_coherence == LateralCoherence::kIndependent) return 0.0;
  double gamma = 0.0;
  for (int m = kBand.first; m <= kBand.last; ++m) {
    gamma += p.model.root_coherence(distance_m(p, pair.iy, pair.iz), m / p.duration_s,
                                    p.mean_speed_mps) /
             kBandWidth;
  }
  return gamma;
}

/// Within 4 standard errors, Var Re(a b*) = (1 + gamma^2)/2.
void expect_coherences(const KaimalFieldParams& p, const std::vector<Pair>& pairs) {
  constexpr int kSeeds = 150;
  const std::vector<Complex> found = coherences(p, pairs, kSeeds);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double gamma = band_coherence(p, pairs[k]);
    const double error = std::sqrt((1.0 + gamma * gamma) / 2.0 / (kBandWidth * kSeeds));
    EXPECT_NEAR(found[k].real(), gamma, 4.0 * error) << "pair " << k;
    EXPECT_NEAR(found[k].imag(), 0.0, 4.0 * error) << "pair " << k;
  }
}

const std::vector<Pair> kThreeSeparations{{0, 0, 1, 0}, {0, 0, 0, 2}, {0, 0, 3, 3}};

// Root coherence of u at 24, 36 and 90 m: 0.52, 0.38, 0.12 in theory (gamma squared: 0.29, 0.17,
// 0.03), over 150 seeds and 8 frequencies (4 standard errors: 0.08); v and w without any by the
// text of IEC; u, v and w of one point independent.
TEST(KaimalField, CoherenceOfU) {
  std::vector<Pair> pairs = kThreeSeparations;
  pairs.insert(pairs.end(), {{1, 1, 1, 0}, {2, 2, 0, 1}, {0, 1, 0, 0}, {0, 2, 0, 0}});
  expect_coherences(small_field(5, LateralCoherence::kIndependent), pairs);
}

// The other convention: v and w with the coherence of u, still independent of each other.
TEST(KaimalField, CoherenceOfTheSameKindForAll) {
  expect_coherences(small_field(5, LateralCoherence::kSameAsU),
                    {{1, 1, 1, 0}, {1, 1, 3, 3}, {2, 2, 0, 1}, {2, 2, 3, 3}, {1, 2, 0, 0}});
}

// Root coherence where all of the band goes the shortest way round the torus (a decay that makes it
// exact there): 0.17, 0.26, 0.11 in theory, gamma squared 0.04, 0.08, 0.02.
TEST(KaimalField, CoherenceTheShortestWay) {
  KaimalFieldParams p = small_field(9, LateralCoherence::kIndependent);
  p.model.coherence_decay = 60.0;
  p.model.coherence_length_m = 100.0;
  ShortestWaySampler sampler({9, 9, 12.0, 9.0}, 1.0);
  ASSERT_EQ(sampler.prepare(p.model.coherence_rate(kBand.first / 128.0, 18.0)), 0.0);
  expect_coherences(p, {{0, 0, 1, 0}, {0, 0, 0, 1}, {0, 0, 1, 1}});
}

}  // namespace
}  // namespace lac::sim
