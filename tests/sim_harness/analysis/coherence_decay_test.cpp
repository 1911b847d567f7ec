// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/coherence_decay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lac::sim {
namespace {

struct Curve {
  std::vector<double> f_hz, coherence, density;
  template <class Function>
  explicit Curve(Function&& gamma2) {
    for (int i = 1; i <= 40; ++i) {
      f_hz.push_back(0.01 * i);
      coherence.push_back(gamma2(f_hz.back()));
      density.push_back(1.0 / (1.0 + std::pow(f_hz.back() / 0.05, 5.0 / 3.0)));
    }
  }
};

// A true exponential gives its own decay back, whatever the weights; the travel time scales it.
TEST(FitDecay, TrueExponential) {
  for (const double decay : {0.2, 4.0, 60.0}) {
    const Curve c([&](double f_hz) { return std::exp(-decay * f_hz * 5.0); });
    const DecayFit fit = fit_decay(c.f_hz, c.coherence, c.density, 5.0, 1.0);
    EXPECT_NEAR(fit.decay / decay, 1.0, 1e-6);
    EXPECT_LT(fit.residual, 1e-6);
    EXPECT_NEAR(fit_decay(c.f_hz, c.coherence, c.density, 2.5, 1.0).decay, 2.0 * decay, 1e-4);
  }
}

// scipy.optimize.minimize_scalar of the same sum for a curve that is no exponential, up to 0.305
// Hz.
TEST(FitDecay, AgreesWithScipy) {
  const Curve c([](double f) { return std::exp(-15.0 * f) + 0.05 * std::cos(180.0 * f); });
  const DecayFit fit = fit_decay(c.f_hz, c.coherence, c.density, 5.0, 0.305);
  EXPECT_NEAR(fit.decay, 3.017968002162138, 1e-5);
  EXPECT_NEAR(fit.residual, 0.03409160844223475, 1e-9);
}

// No frequency below the limit: nothing is fitted.
TEST(FitDecay, NothingToFit) {
  const Curve c([](double) { return 0.5; });
  EXPECT_TRUE(std::isnan(fit_decay(c.f_hz, c.coherence, c.density, 5.0, 0.001).decay));
}

}  // namespace
}  // namespace lac::sim
