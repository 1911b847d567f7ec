// SPDX-License-Identifier: Apache-2.0
#include "core/kaimal.hpp"

#include <gtest/gtest.h>

namespace lac {
namespace {

// The closed-form variance is the integral of the spectrum, here by Simpson's rule.
TEST(Kaimal, VarianceIsTheIntegralOfTheSpectrum) {
  const KaimalModel model = iec_kaimal(2.0, 90.0);
  const int n = 200000;
  const double f1 = 0.01, f2 = 5.0, h = (f2 - f1) / n;
  double sum = model.u.spectrum(f1, 16.0) + model.u.spectrum(f2, 16.0);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * model.u.spectrum(f1 + i * h, 16.0);
  EXPECT_NEAR(sum * h / 3.0, model.u.variance(f1, f2, 16.0), 1e-8);
  EXPECT_NEAR(model.u.variance(0.0, 1e12, 16.0), 4.0, 1e-6);
}

// IEC 61400-1: scales at a hub height above and below 60 m.
TEST(Kaimal, IecScales) {
  const KaimalModel high = iec_kaimal(2.82, 90.0);
  EXPECT_NEAR(high.u.length_scale_m, 340.2, 1e-9);
  EXPECT_NEAR(high.v.length_scale_m, 113.4, 1e-9);
  EXPECT_NEAR(high.w.length_scale_m, 27.72, 1e-9);
  EXPECT_NEAR(high.v.sigma_mps, 0.8 * 2.82, 1e-12);
  EXPECT_NEAR(iec_kaimal(1.0, 40.0).u.length_scale_m, 8.1 * 28.0, 1e-9);
}

// gamma = exp(-12 r sqrt((f/U)^2 + (0.12/L)^2)): one value worked by hand.
TEST(Kaimal, RootCoherence) {
  const KaimalModel model = iec_kaimal(1.0, 90.0);
  const double c = 12.0 * std::sqrt(0.1 * 0.1 / 256.0 + 0.12 * 0.12 / (340.2 * 340.2));
  EXPECT_NEAR(model.root_coherence(20.0, 0.1, 16.0), std::exp(-20.0 * c), 1e-14);
  EXPECT_EQ(model.root_coherence(0.0, 0.1, 16.0), 1.0);
}

}  // namespace
}  // namespace lac
