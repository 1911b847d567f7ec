// SPDX-License-Identifier: Apache-2.0
// The generated field against theory over many seeds. All stochastic checks use the exact standard
// error of their estimator for complex normal amplitudes, and fixed seeds.
#include "sim_harness/wind/kaimal_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/error.hpp"
#include "tests/sim_harness/wind/kaimal_reference.hpp"

namespace lac::sim {
namespace {

/// Mean of gamma^2 over all pairs of grid points: what averaging |A|^2 over the points leaves of
/// its variance.
double mean_square_coherence(const KaimalFieldParams& p, int m) {
  const int n = p.ny * p.nz;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double r_m = distance_m(p, i % p.ny - j % p.ny, i / p.ny - j / p.ny);
      sum += std::pow(p.model.root_coherence(r_m, m / p.duration_s, p.mean_speed_mps), 2);
    }
  }
  return sum / n / n;
}

struct Band {
  int first;
  int last;
};
constexpr std::array<Band, 4> kBands{{{1, 4}, {5, 16}, {17, 50}, {51, 127}}};

/// Chi-square quantile over its degrees of freedom (Wilson and Hilferty).
double chi_square_ratio(double degrees, double normal_quantile) {
  const double a = 2.0 / (9.0 * degrees);
  return std::pow(1.0 - a + normal_quantile * std::sqrt(a), 3);
}

struct SpectrumCase {
  int points;
  LateralCoherence lateral;
};

class KaimalSpectrum : public testing::TestWithParam<SpectrumCase> {};

// One-point spectra of u, v, w over all points and 30 seeds: in each of four bands the mean ratio
// to theory lies in the 99.9 % chi-square band with the degrees of freedom that the coherence of
// the points leaves (within 17 % in the lowest, 1 % in the highest). 12 checks per case.
TEST_P(KaimalSpectrum, AgreesWithTheoryInEveryBand) {
  constexpr int kSeeds = 30;
  KaimalFieldParams p = small_field(GetParam().points, GetParam().lateral);
  double ratio[3][kBands.size()] = {};
  std::array<std::array<double, 128>, 3> theory;
  for (int c = 0; c < 3; ++c) {
    for (int m = 1; m < 128; ++m) theory[c][m] = bin_variance(p, c, m);
  }
  for (p.seed = 1; p.seed <= kSeeds; ++p.seed) {
    const GriddedWind wind = make_kaimal_field(p);
    for (int point = 0; point < p.ny * p.nz; ++point) {
      for (int c = 0; c < 3; ++c) {
        const auto a = amplitudes(wind, point / p.ny, point % p.ny, c);
        for (std::size_t b = 0; b < kBands.size(); ++b) {
          for (int m = kBands[b].first; m <= kBands[b].last; ++m)
            ratio[c][b] += std::norm(a[m]) / 2.0 / theory[c][m];
        }
      }
    }
  }
  for (int c = 0; c < 3; ++c) {
    const bool coherent = c == 0 || p.lateral_coherence == LateralCoherence::kSameAsU;
    for (std::size_t b = 0; b < kBands.size(); ++b) {
      const int width = kBands[b].last - kBands[b].first + 1;
      double variance = 0.0;
      for (int m = kBands[b].first; m <= kBands[b].last; ++m)
        variance += coherent ? mean_square_coherence(p, m) : 1.0 / (p.ny * p.nz);
      const double degrees = 2.0 * width * width * kSeeds / variance;
      const double found = ratio[c][b] / (width * kSeeds * p.ny * p.nz);
      EXPECT_GT(found, chi_square_ratio(degrees, -3.29)) << "component " << c << " band " << b;
      EXPECT_LT(found, chi_square_ratio(degrees, 3.29)) << "component " << c << " band " << b;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samplers, KaimalSpectrum,
                         testing::Values(SpectrumCase{5, LateralCoherence::kIndependent},
                                         SpectrumCase{5, LateralCoherence::kSameAsU},
                                         SpectrumCase{9, LateralCoherence::kIndependent}));

// Variance in time at single points (corner, edge, centre) over 150 seeds against the closed form
// between half a step and the Nyquist frequency plus half a step: within 4 standard errors.
TEST(KaimalField, VariancePerPoint) {
  constexpr int kSeeds = 150;
  KaimalFieldParams p = small_field(5, LateralCoherence::kIndependent);
  const int nt = 256, points[3][2] = {{0, 0}, {0, 2}, {2, 2}};
  double found[3][3] = {};
  for (p.seed = 1; p.seed <= kSeeds; ++p.seed) {
    const GriddedWind wind = make_kaimal_field(p);
    for (int k = 0; k < 3; ++k) {
      for (int c = 0; c < 3; ++c) {
        for (int it = 0; it < nt; ++it) {
          const double mean = c == 0 ? p.mean_speed_mps : 0.0;
          found[k][c] +=
              std::pow(wind.grid().at(it, points[k][0], points[k][1], c) - mean, 2) / nt / kSeeds;
        }
      }
    }
  }
  for (int c = 0; c < 3; ++c) {
    double error_squared = 0.0;
    for (int m = 1; m <= nt / 2; ++m)
      error_squared += (2 * m == nt ? 2.0 : 1.0) * std::pow(bin_variance(p, c, m), 2) / kSeeds;
    const double expected =
        component_of(p.model, c)
            .variance(0.5 / p.duration_s, (0.5 * nt + 0.5) / p.duration_s, p.mean_speed_mps);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(found[k][c], expected, 4.0 * std::sqrt(error_squared)) << c << ' ' << k;
  }
}

bool same_bits(const GriddedWind& a, const GriddedWind& b) {
  for (int it = 0; it < a.grid().spec().nt; ++it) {
    if (!std::ranges::equal(a.grid().plane(it), b.grid().plane(it))) return false;
  }
  return true;
}

// The field depends on the seed alone, not on the number of threads, to the last bit.
TEST(KaimalField, SameSeedSameFieldOnAnyNumberOfThreads) {
  KaimalFieldParams p = small_field(9, LateralCoherence::kSameAsU);
  const GriddedWind one = make_kaimal_field(p);
  for (int threads : {1, 2, 3}) {
    p.threads = threads;
    EXPECT_TRUE(same_bits(one, make_kaimal_field(p))) << threads;
  }
  p.seed = 2;
  EXPECT_FALSE(same_bits(one, make_kaimal_field(p)));
}

// Without turbulence the mean profile is left: U (z / z_hub)^exponent, grid centred on the hub;
// also with an odd number of steps.
TEST(KaimalField, MeanProfile) {
  KaimalFieldParams p = small_field(5, LateralCoherence::kIndependent);
  p.model.u.sigma_mps = p.model.v.sigma_mps = p.model.w.sigma_mps = 0.0;
  p.shear_exponent = 0.2;
  p.duration_s = 127.5;
  const GriddedWind wind = make_kaimal_field(p);
  EXPECT_EQ(wind.extent().z_min_m, 54.0);
  EXPECT_EQ(wind.duration_s(), 127.5);
  EXPECT_NEAR(wind.velocity({0.0, 0.0, 54.0}, 1.0).x, 18.0 * std::pow(54.0 / 90.0, 0.2), 2e-6);
  EXPECT_NEAR(wind.velocity({0.0, 48.0, 90.0}, 1.0).x, 18.0, 2e-6);
  EXPECT_EQ(wind.velocity({0.0, 48.0, 90.0}, 1.0).y, 0.0);
}

// The time average over the period is the mean speed at every point, with an odd number of steps
// too (frequency zero carries no turbulence): to float accuracy.
TEST(KaimalField, NoTurbulenceAtFrequencyZero) {
  KaimalFieldParams p = small_field(5, LateralCoherence::kIndependent);
  for (double duration_s : {128.0, 127.5}) {
    p.duration_s = duration_s;
    const GriddedWind wind = make_kaimal_field(p);
    const int nt = wind.grid().spec().nt;
    double mean = 0.0;
    for (int it = 0; it < nt; ++it) mean += wind.grid().at(it, 1, 3, 0) / nt;
    EXPECT_NEAR(mean, 18.0, 5e-6);
  }
}

// What the field says about its coherence: within single precision, at one of its frequencies.
TEST(KaimalField, ReportsItsCoherenceError) {
  KaimalPlanes planes(small_field(9, LateralCoherence::kIndependent));
  planes.next(0.0);
  EXPECT_LE(planes.report().coherence_error, 1e-7);
  EXPECT_GT(planes.report().coherence_error, 0.0);
  EXPECT_GE(planes.report().frequency_hz, 1.0 / 128.0);
  EXPECT_LE(planes.report().frequency_hz, 1.0);
}

// Points that do all the same, nearly: a coherence of one is drawn, not refused.
TEST(KaimalField, NearlyFullCoherence) {
  KaimalFieldParams p = small_field(5, LateralCoherence::kIndependent);
  p.model.coherence_decay = 1e-12;
  const GriddedWind wind = make_kaimal_field(p);
  for (const int it : {0, 17, 255})
    EXPECT_NEAR(wind.grid().at(it, 0, 0, 0), wind.grid().at(it, 4, 4, 0), 1e-4);
}

void expect_refused(const KaimalFieldParams& params, const char* text) {
  try {
    make_kaimal_field(params);
    FAIL() << text << " was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(text));
  }
}

// What cannot be generated is refused by name.
TEST(KaimalField, RefusesBadParameters) {
  const KaimalFieldParams good = small_field(5, LateralCoherence::kIndependent);
  KaimalFieldParams p = good;
  p.duration_s = 128.2;
  expect_refused(p, "duration_s = 128.2");
  p = good;
  p.dt_s = 0.0;
  expect_refused(p, "dt_s = 0");
  p = good;
  p.ny = 1;
  expect_refused(p, "ny = 1");
  p = good;
  p.height_m = 200.0;
  expect_refused(p, "z_bottom_m = -10");
  p = good;
  p.model.v.sigma_mps = std::nan("");
  expect_refused(p, "sigma_v = nan");
  p = good;
  p.model.coherence_decay = 0.0;
  expect_refused(p, "coherence_decay = 0");
  p = good;
  p.model.coherence_length_m = -340.2;
  expect_refused(p, "coherence_length_m = -340.2");
  p = good;
  p.model.u.length_scale_m = 0.0;
  expect_refused(p, "length scale of u = 0");
  p = good;
  p.threads = 0;
  expect_refused(p, "threads = 0");
  p = good;
  p.duration_s = 3.0;
  expect_refused(p, "duration_s / dt_s = 6");
  p = good;
  p.width_m = 1e-4;
  expect_refused(p, "a grid less elongated");
  p.width_m = 0.01;
  p.ny = 30;
  p.nz = 1000;
  p.duration_s = 8.0;
  expect_refused(p, "points of the torus of the coherence");
}

}  // namespace
}  // namespace lac::sim
