// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/theory_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim_harness/wind_check/field_amplitudes.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

/// 9 x 9 points on 96 x 96 m, 256 s at 2 Hz.
KaimalFieldParams params(std::uint64_t seed) {
  KaimalFieldParams p;
  p.ny = p.nz = 9;
  p.width_m = p.height_m = 96.0;
  p.dt_s = 0.5;
  p.duration_s = 256.0;
  p.threads = 1;
  p.seed = seed;
  p.lateral_coherence = LateralCoherence::kSameAsU;
  return p;
}

KaimalTheory theory_of(const KaimalFieldParams& p) {
  return {p.model, p.mean_speed_mps, p.lateral_coherence};
}

/// The same numbers as a field that does not repeat.
GriddedWind not_periodic(const GriddedWind& wind) {
  GridSpec spec = wind.grid().spec();
  spec.periodic = false;
  VelocityGrid grid(spec);
  for (int it = 0; it < spec.nt; ++it) {
    const auto from = wind.grid().plane(it);
    std::copy(from.begin(), from.end(), grid.plane(it).begin());
  }
  return GriddedWind(std::move(grid));
}

/// How often 95 % limits hold what they are for.
struct Count {
  int inside = 0;
  int all = 0;

  void add(const CheckPoint& p) {
    ++all;
    if (p.found >= p.low && p.found <= p.high) ++inside;
  }
  double share() const { return static_cast<double>(inside) / all; }
};

struct Counts {
  Count spectra, coherences, sigmas;
  int passed = 0;
};

Counts counts(int seeds, bool periodic) {
  Counts c;
  const CheckSettings strict{
      .confidence = 0.99, .spectrum_allowance = 0.0, .coherence_allowance = 0.0};
  for (int seed = 1; seed <= seeds; ++seed) {
    const KaimalFieldParams p = params(static_cast<std::uint64_t>(seed));
    const GriddedWind wind = make_kaimal_field(p);
    const TheoryCheck check =
        check_field(periodic ? wind : not_periodic(wind), theory_of(p), strict);
    c.passed += check.passed() ? 1 : 0;
    for (const CheckCurve& curve : check.spectra) {
      for (const CheckPoint& point : curve.points) c.spectra.add(point);
    }
    for (const CheckCurve& curve : check.coherences) {
      for (const CheckPoint& point : curve.points) c.coherences.add(point);
    }
    for (const CheckPoint& point : check.sigmas) c.sigmas.add(point);
  }
  return c;
}

// 100 periodic fields of the theory itself, nothing allowed: the 95 % limits hold 95 % within
// 1.5 % for spectra and coherences (thousands of values, correlated within a field), 3 % for the
// 300 standard deviations; of 100 fields at 99 % confidence at most 5 are refused (probability
// 0.05 % if the confidence is as stated).
TEST(TheoryCheck, LimitsHoldForPeriodicFields) {
  const Counts c = counts(100, true);
  EXPECT_NEAR(c.spectra.share(), 0.95, 0.015) << c.spectra.all;
  EXPECT_NEAR(c.coherences.share(), 0.95, 0.015) << c.coherences.all;
  EXPECT_NEAR(c.sigmas.share(), 0.95, 0.03);
  EXPECT_GE(c.passed, 95);
}

// The same fields cut out of time: windows, overlap and leakage are allowed for.
TEST(TheoryCheck, LimitsHoldForOtherFields) {
  const Counts c = counts(100, false);
  EXPECT_NEAR(c.spectra.share(), 0.95, 0.015) << c.spectra.all;
  EXPECT_NEAR(c.coherences.share(), 0.95, 0.02) << c.coherences.all;
  EXPECT_NEAR(c.sigmas.share(), 0.95, 0.03);
  EXPECT_GE(c.passed, 95);
}

// A theory that is not the field's is found out, with the usual allowances: 15 % more variance, a
// length scale of 60 %, less decay of coherence, v and w independent.
TEST(TheoryCheck, WrongTheoriesAreRefused) {
  const KaimalFieldParams p = params(7);
  const GriddedWind wind = make_kaimal_field(p);
  EXPECT_TRUE(check_field(wind, theory_of(p)).passed());
  KaimalFieldParams other = p;
  other.model.u.sigma_mps *= std::sqrt(1.15);
  const TheoryCheck variance = check_field(wind, theory_of(other));
  EXPECT_FALSE(variance.passed());
  EXPECT_GT(variance.sigmas[0].expected, variance.sigmas[0].found);
  other = p;
  other.model.w.length_scale_m *= 0.6;
  EXPECT_FALSE(check_field(wind, theory_of(other)).passed());
  other = p;
  other.model.coherence_decay = 9.0;
  EXPECT_FALSE(check_field(wind, theory_of(other)).passed());
  other = p;
  other.lateral_coherence = LateralCoherence::kIndependent;
  EXPECT_FALSE(check_field(wind, theory_of(other)).passed());
}

// What is reported: bands from 1/T to below Nyquist, sigma the closed form between half a step
// below and above, separations from the grid, found next to expected.
TEST(TheoryCheck, Report) {
  const KaimalFieldParams p = params(1);
  const TheoryCheck check = check_field(make_kaimal_field(p), theory_of(p));
  EXPECT_DOUBLE_EQ(check.lowest_hz, 1.0 / 256.0);
  EXPECT_DOUBLE_EQ(check.highest_hz, 255.0 / 256.0);
  EXPECT_EQ(check.lattice_points, 81);
  ASSERT_EQ(check.spectra.size(), 3u);
  ASSERT_EQ(check.coherences.size(), 12u);  // 12, 24, 48 m across and 24 m up
  EXPECT_EQ(check.coherences[0].dy_m, 12.0);
  EXPECT_EQ(check.coherences[2].dy_m, 48.0);
  EXPECT_EQ(check.coherences[3].dz_m, 24.0);
  EXPECT_EQ(check.coherences[11].component, 2);
  const double sigma_w = std::sqrt(p.model.w.variance(0.5 / 256.0, 255.5 / 256.0, 18.0));
  EXPECT_NEAR(check.sigmas[2].expected, sigma_w, 1e-4 * sigma_w);
  const CheckPoint& first = check.coherences[0].points[0];
  EXPECT_NEAR(first.expected, p.model.root_coherence(12.0, first.frequency_hz, 18.0), 1e-3);
}

// A great grid is thinned to 900 points or fewer, at a regular step.
TEST(TheoryCheck, GreatGridsAreThinned) {
  const GridSampling s = sample_grid({127, 64, 8, 2.0, 3.0, 1.0, 0.0, 90.0, 10.0, true}, 900);
  EXPECT_EQ(s.stride, 4);
  EXPECT_EQ(s.lattice.ny, 32);
  EXPECT_EQ(s.lattice.nz, 16);
  EXPECT_EQ(s.lattice.dy_m, 8.0);
}

// Settings that cannot be.
TEST(TheoryCheck, Refuses) {
  const KaimalFieldParams p = params(1);
  const GriddedWind wind = make_kaimal_field(p);
  const auto error = [&](const CheckSettings& s) {
    return lac::test::error_text([&] { check_field(wind, theory_of(p), s); });
  };
  EXPECT_THAT(error({.confidence = 1.0}), ::testing::HasSubstr("wind check: confidence = 1"));
  EXPECT_THAT(error({.spectrum_allowance = -1.0}), ::testing::HasSubstr("spectrum_allowance"));
  EXPECT_THAT(error({.max_frequency_hz = 1e-4}), ::testing::HasSubstr("max_frequency_hz"));
}

}  // namespace
}  // namespace lac::sim
