// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/figures_of_merit.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/units.hpp"

namespace lac::sim {
namespace {

using testing::Optional;

constexpr double kCutoff_hz = 0.05;

/// A curve whose gain is that of a first-order low-pass and whose coherence is 1/(1 + (k/k_0)^2).
CorrelationCurve first_order_curve(double half_coherence_radpm) {
  CorrelationCurve c{16.0, {}, {}, {}, {}};
  for (int i = 0; i < 61; ++i) {
    const double k1 = 1e-3 * std::pow(150.0, i / 60.0);
    c.k1_radpm.push_back(k1);
    const double ratio = c.frequency_hz(c.k1_radpm.size() - 1) / kCutoff_hz;
    const double gain = 1.0 / std::hypot(1.0, ratio), x = k1 / half_coherence_radpm;
    c.s_ll.push_back(2.0);
    c.s_rl.push_back(2.0 * gain);
    c.s_rr.push_back(2.0 * gain * gain * (1.0 + x * x));
  }
  return c;
}

// A first-order low-pass is -3 dB (0.7079) at 0.9977 f_c, and is found again by the fit.
TEST(FiguresOfMerit, FindsAFirstOrderLowPass) {
  const FiguresOfMerit f = figures_of_merit(first_order_curve(0.025));
  const double minus_3_db_hz = kCutoff_hz * std::sqrt(std::pow(10.0, 0.3) - 1.0);
  ASSERT_TRUE(f.cutoff_hz && f.fitted_cutoff_hz && f.k05_radpm);
  EXPECT_NEAR(*f.cutoff_hz, minus_3_db_hz, 1e-6);
  EXPECT_NEAR(*f.fitted_cutoff_hz, kCutoff_hz, 1e-6);
  EXPECT_NEAR(*f.k05_radpm, 0.025, 1e-6);
  EXPECT_NEAR(*f.smallest_eddy_m(), 2.0 * kPi / 0.025, 0.02);
}

// 251.3 m: classes by the diameter; at the border the better one.
TEST(FiguresOfMerit, ClassesEddiesByTheDiameter) {
  FiguresOfMerit f;
  f.k05_radpm = 0.025;
  const double eddy_m = *f.smallest_eddy_m();
  EXPECT_THAT(f.eddy_class(eddy_m), Optional(EddyClass::kVeryGood));
  EXPECT_THAT(f.eddy_class(eddy_m / 1.4), Optional(EddyClass::kGood));
  EXPECT_THAT(f.eddy_class(eddy_m / 1.9), Optional(EddyClass::kAverage));
  EXPECT_THAT(f.eddy_class(eddy_m / 2.9), Optional(EddyClass::kSufficient));
  EXPECT_THAT(f.eddy_class(eddy_m / 3.1), Optional(EddyClass::kPoor));
  EXPECT_STREQ(text_of(EddyClass::kAverage), "average");
}

// What a curve does not reach is not extrapolated.
TEST(FiguresOfMerit, LeavesOutWhatIsNotReached) {
  const FiguresOfMerit f = figures_of_merit(first_order_curve(10.0));
  EXPECT_FALSE(f.k05_radpm);
  EXPECT_FALSE(f.smallest_eddy_m());
  EXPECT_FALSE(f.eddy_class(100.0));
  EXPECT_FALSE(first_crossing({1.0, 2.0, 3.0}, {0.4, 0.3, 0.2}, 0.5));  // below from the start
}

// The first of several downward crossings counts; a cubic in log x is met exactly.
TEST(FirstCrossing, IsTheFirstDownwardOne) {
  std::vector<double> x, y;
  for (int i = 0; i <= 20; ++i) {
    x.push_back(std::exp(0.2 * i));
    const double t = std::log(x.back());
    y.push_back(std::pow(1.5 - t, 3.0));
  }
  y.back() = 9.0;
  x.push_back(2.0 * x.back());
  y.push_back(-9.0);
  ASSERT_TRUE(first_crossing(x, y, 0.2));
  EXPECT_NEAR(std::log(*first_crossing(x, y, 0.2)), 1.5 - std::cbrt(0.2), 1e-9);
}

}  // namespace
}  // namespace lac::sim
