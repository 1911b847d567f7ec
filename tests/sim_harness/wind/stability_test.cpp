// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/stability.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr Stability kClasses[] = {Stability::kUnstable, Stability::kNeutral, Stability::kStable};
constexpr double kSpeed_mps = 16.0;

// Both sets of a class are one kind of turbulence: sigma_u within 3 %, f S / sigma^2 of u within
// 0.03 (of v and w 0.08) and the coherence of u at dy = dz = 20 m within 0.13, over the range of
// the fit.
TEST(Stability, KaimalFollowsMann) {
  for (const Stability stability : kClasses) {
    const MannTensor phi(stability_mann(stability));
    const KaimalModel kaimal = stability_kaimal(stability, 2.82);
    const SpectralTensor variance = phi.covariance();
    EXPECT_NEAR(std::sqrt(variance[kUu]) / kaimal.u.sigma_mps, 1.0, 0.03);
    const KaimalComponent* components[] = {&kaimal.u, &kaimal.v, &kaimal.w};
    for (const double k1 : {5e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1}) {
      const double f_hz = k1 * kSpeed_mps / (2.0 * kPi);
      const SpectralTensor spectra = phi.spectra(k1);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(f_hz * components[c]->spectrum(f_hz, kSpeed_mps) / variance[c],
                    2.0 * k1 * spectra[c] / variance[c], c == 0 ? 0.03 : 0.08)
            << k1 << ' ' << c;
      }
      const double coherence = phi.cross_spectra(k1, {20.0, 20.0, 0.0})[kUu].real() / spectra[kUu];
      EXPECT_NEAR(kaimal.root_coherence(std::hypot(20.0, 20.0), f_hz, kSpeed_mps), coherence, 0.13)
          << k1;
    }
  }
}

// The exponential coherence along the wind belongs to the evolution of the Mann set: at 100 m
// within 0.04 (squared) below 0.01 rad/m.
TEST(Stability, ExponentialEvolutionFollowsSpaceTimeTensor) {
  for (const Stability stability : kClasses) {
    const MannTensor phi(stability_mann(stability));
    const ExponentialEvolution evolution = stability_evolution(stability);
    for (const double k1 : {3e-4, 1e-3, 3e-3, 0.01}) {
      const double root =
          phi.cross_spectra(k1, {0.0, 0.0, 100.0 / kSpeed_mps})[kUu].real() / phi.spectra(k1)[kUu];
      const double fit =
          std::exp(-evolution.decay * 100.0 * std::hypot(k1 / (2.0 * kPi), evolution.offset_per_m));
      EXPECT_NEAR(root * root, fit, 0.04) << k1;
    }
  }
}

// Scaling acts on the three standard deviations alone.
TEST(Stability, ScaledKaimal) {
  const KaimalModel model = stability_kaimal(Stability::kUnstable, 1.41);
  EXPECT_DOUBLE_EQ(model.u.sigma_mps, 1.41);
  EXPECT_DOUBLE_EQ(model.v.sigma_mps, 1.17);
  EXPECT_DOUBLE_EQ(model.w.sigma_mps, 0.99);
  EXPECT_EQ(model.u.length_scale_m, 744.8);
  EXPECT_EQ(model.coherence_length_m, 1502.0);
}

}  // namespace
}  // namespace lac::sim
