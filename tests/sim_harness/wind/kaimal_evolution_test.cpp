// SPDX-License-Identifier: Apache-2.0
// Planes of evolving Kaimal turbulence against theory, over seeds which are fixed: the products of
// complex normal amplitudes have a standard error that is known exactly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "core/error.hpp"
#include "sim_harness/wind/stability.hpp"
#include "tests/sim_harness/wind/kaimal_reference.hpp"
#include "tests/sim_harness/wind/plane_comparison.hpp"

namespace lac::sim {
namespace {

constexpr struct Band { int first, last; } kBands[] = {{1, 3}, {4, 12}, {13, 40}, {41, 127}};
const std::vector<double> kDistances{0.0, 50.0, 100.0, 170.0};
constexpr int kSeeds = 60;

/// One component at a grid point of one plane.
struct Channel {
  int component, iy, iz, plane;
};
struct Pair {
  Channel a, b;
};

KaimalFieldParams class_field(Stability stability, LateralCoherence lateral) {
  KaimalFieldParams p = small_field(5, lateral);
  p.mean_speed_mps = 16.0;
  p.model = stability_kaimal(stability, 2.82);
  p.evolution = stability_evolution(stability);
  return p;
}

/// Root coherence of the model.
double theory(const KaimalFieldParams& p, const Pair& pair, int m) {
  const auto& [a, b] = pair;
  if (a.component != b.component) return 0.0;
  const double r_m = distance_m(p, a.iy - b.iy, a.iz - b.iz), f_hz = m / p.duration_s;
  const bool coherent = a.component == 0 || p.lateral_coherence == LateralCoherence::kSameAsU;
  const double across = coherent ? p.model.root_coherence(r_m, f_hz, p.mean_speed_mps) : r_m == 0.0;
  const double dx_m = std::abs(kDistances[a.plane] - kDistances[b.plane]);
  const double squared = std::exp(-p.evolution.decay * dx_m *
                                  std::hypot(f_hz / p.mean_speed_mps, p.evolution.offset_per_m));
  return across * std::sqrt(squared);
}

/// Mean over seeds and each band of A_a conj(A_b), normalised with the theoretical spectra.
std::vector<std::vector<Complex>> products(const KaimalFieldParams& p,
                                           const std::vector<Pair>& pairs) {
  std::vector<std::vector<Complex>> mean(pairs.size(), std::vector<Complex>(std::size(kBands)));
  KaimalPlanes planes(p);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    planes.restart(seed);
    std::vector<GriddedWind> winds;
    for (const double d_m : kDistances) winds.push_back(planes.next(d_m));
    const auto of = [&](const Channel& c) {
      return amplitudes(winds[c.plane], c.iz, c.iy, c.component);
    };
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto a = of(pairs[k].a), b = of(pairs[k].b);
      for (std::size_t i = 0; i < std::size(kBands); ++i) {
        const double count = (kBands[i].last - kBands[i].first + 1.0) * kSeeds;
        for (int m = kBands[i].first; m <= kBands[i].last; ++m) {
          const double power = std::sqrt(bin_variance(p, pairs[k].a.component, m) *
                                         bin_variance(p, pairs[k].b.component, m));
          mean[k][i] += a[m] * std::conj(b[m]) / (2.0 * power * count);
        }
      }
    }
  }
  return mean;
}

/// Within 4.5 standard errors, Var Re(a b*) = (1 + gamma^2) / 2 and Var Im = (1 - gamma^2) / 2.
void expect_products(const KaimalFieldParams& p, const std::vector<Pair>& pairs) {
  const auto found = products(p, pairs);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    for (std::size_t i = 0; i < std::size(kBands); ++i) {
      const double count = kBands[i].last - kBands[i].first + 1.0;
      double gamma = 0.0, gamma_2 = 0.0;
      for (int m = kBands[i].first; m <= kBands[i].last; ++m) {
        const double g = theory(p, pairs[k], m);
        gamma += g / count, gamma_2 += g * g / count;
      }
      const double real = std::sqrt((1.0 + gamma_2) / 2.0 / count / kSeeds);
      const double imaginary = std::sqrt(std::max(1.0 - gamma_2, 0.0) / 2.0 / count / kSeeds);
      EXPECT_NEAR(found[k][i].real(), gamma, 4.5 * real) << "pair " << k << " band " << i;
      EXPECT_NEAR(found[k][i].imag(), 0.0, 4.5 * imaginary + 1e-6) << "pair " << k << " band " << i;
    }
  }
}

using Turbulence = std::tuple<Stability, LateralCoherence>;
class KaimalEvolution : public testing::TestWithParam<Turbulence> {
 protected:
  KaimalFieldParams field() const {
    return class_field(std::get<0>(GetParam()), std::get<1>(GetParam()));
  }
};

// Spectra of u, v, w in the first and the last plane; coherence at five separations across the wind
// (18 to 120 m) in both; along the wind at 50, 100 and 170 m, between two planes up-wind (the
// recursion is Markov), and across and along at once: mean of 60 seeds in four bands of frequency.
// 208 numbers per case within 4.5 standard errors: false alarm 1.4e-3.
TEST_P(KaimalEvolution, SpectraAndCoherence) {
  std::vector<Pair> pairs;
  for (const int plane : {0, 3}) {
    for (int c = 0; c < 3; ++c) pairs.push_back({{c, 3, 1, plane}, {c, 3, 1, plane}});
    for (const auto& [iy, iz] : {std::pair{0, 1}, {1, 0}, {1, 1}, {2, 2}, {4, 4}})
      pairs.push_back({{0, 0, 0, plane}, {0, iy, iz, plane}});
  }
  for (int plane = 1; plane < 4; ++plane) pairs.push_back({{0, 2, 2, 0}, {0, 2, 2, plane}});
  pairs.push_back({{0, 2, 2, 1}, {0, 2, 2, 3}});
  pairs.push_back({{0, 0, 0, 0}, {0, 1, 1, 2}});
  pairs.push_back({{1, 2, 2, 0}, {1, 2, 2, 2}});
  pairs.push_back({{2, 0, 0, 0}, {2, 0, 1, 1}});
  pairs.push_back({{0, 2, 2, 0}, {1, 2, 2, 0}});
  pairs.push_back({{1, 2, 2, 0}, {2, 2, 2, 1}});
  pairs.push_back({{2, 2, 2, 1}, {0, 2, 2, 2}});
  expect_products(field(), pairs);
}

INSTANTIATE_TEST_SUITE_P(
    Classes, KaimalEvolution,
    testing::Combine(testing::Values(Stability::kUnstable, Stability::kNeutral, Stability::kStable),
                     testing::Values(LateralCoherence::kIndependent, LateralCoherence::kSameAsU)));

KaimalFieldParams neutral_field() {
  return class_field(Stability::kNeutral, LateralCoherence::kSameAsU);
}

// All planes at once are those drawn one by one, whole and thinned, on any number of threads; a
// plane of which nothing is wanted does not change those behind it.
TEST(KaimalPlanes, AllAtOnceAsOneByOne) {
  const PlaneLayout layout({50.0, 100.0, 170.0});
  const WindDemand demand{{}, {{-52.0, 3.0, 85.0}, {-180.0, -20.0, 80.0}}, 1.0};
  KaimalFieldParams p = neutral_field();
  for (const int threads : {1, 2, 3}) {
    p.threads = threads;
    EXPECT_TRUE(same_as_one_by_one(draw_evolving_kaimal(p, layout), KaimalPlanes(neutral_field())));
    const EvolvingGrids thinned = draw_evolving_kaimal(p, layout, &demand);
    EXPECT_EQ(thinned.upwind[0].columns().count(), 4U);
    EXPECT_EQ(thinned.upwind[1].columns().count(), 0U);
    EXPECT_TRUE(same_as_one_by_one(thinned, KaimalPlanes(neutral_field())));
  }
  p.seed = 2;
  EXPECT_FALSE(same_as_one_by_one(draw_evolving_kaimal(p, layout), KaimalPlanes(neutral_field())));
}

// The first plane is the frozen field of the same seed, to the last bit, also after a restart; the
// second one is another.
TEST(KaimalPlanes, FirstPlaneIsTheFrozenField) {
  const KaimalFieldParams p = neutral_field();
  const VelocityGrid frozen = make_kaimal_field(p).take_grid();
  KaimalPlanes planes(p);
  EXPECT_TRUE(same_bits(planes.next(0.0).take_grid(), frozen));
  EXPECT_FALSE(same_bits(planes.next(50.0).take_grid(), frozen));
  planes.restart(2);
  EXPECT_FALSE(same_bits(planes.next(0.0).take_grid(), frozen));
  planes.restart(p.seed);
  EXPECT_TRUE(same_bits(planes.next(0.0).take_grid(), frozen));
}

// Without decay every plane is the first.
TEST(KaimalPlanes, FrozenPlanes) {
  KaimalPlanes planes(small_field(5, LateralCoherence::kIndependent));
  const VelocityGrid rotor = planes.next(0.0).take_grid();
  EXPECT_TRUE(same_bits(planes.next(80.0).take_grid(), rotor));
}

// Distances that do not rise from 0, parameters out of range, planes of frozen turbulence.
TEST(KaimalPlanes, RefusesBadParameters) {
  using testing::HasSubstr;
  const auto error_of = [](const auto& act) -> std::string {
    try {
      act();
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  KaimalPlanes planes(neutral_field());
  EXPECT_THAT(error_of([&] { planes.next(50.0); }), HasSubstr("expected 0 for the first"));
  planes.next(0.0);
  EXPECT_THAT(error_of([&] { planes.next(0.0); }), HasSubstr("distance of a plane [m] = 0"));
  KaimalFieldParams p = neutral_field();
  p.evolution.offset_per_m = -1e-4;
  EXPECT_THAT(error_of([&] { KaimalPlanes{p}; }), HasSubstr("evolution.offset_per_m = -0.0001"));
  p.evolution = {std::nan(""), 0.0};
  EXPECT_THAT(error_of([&] { KaimalPlanes{p}; }), HasSubstr("evolution.decay = nan"));
  p.evolution = {};
  EXPECT_THAT(error_of([&] { draw_evolving_kaimal(p, PlaneLayout({50.0})); }),
              HasSubstr("evolution.decay = 0"));
}

}  // namespace
}  // namespace lac::sim
