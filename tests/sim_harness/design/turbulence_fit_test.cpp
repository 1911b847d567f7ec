// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/turbulence_fit.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/wind/stability.hpp"

namespace lac::sim {
namespace {

MannParams scaled(Stability stability, double evolution_s) {
  MannParams p = scaled_to_sigma_u(stability_mann(stability), kStabilitySigmaU_mps);
  p.evolution_s = evolution_s;
  return p;
}

void expect_within(double share, double found, double printed, const char* what) {
  EXPECT_NEAR(found / printed, 1.0, share) << what << ": " << found << ", printed " << printed;
}

// GUO Table 2: exponential coherence along the wind for three classes and three evolutions.
TEST(TurbulenceFit, MeetsTheSecondPublishedTable) {
  struct Row {
    Stability stability;
    double evolution_s, decay, offset_per_m;
  };
  for (const Row& row :
       {Row{Stability::kUnstable, 200.0, 8.2, 8.52e-5},
        Row{Stability::kUnstable, 400.0, 5.1, 8.02e-5},
        Row{Stability::kUnstable, 600.0, 4.1, 7.67e-5},
        Row{Stability::kNeutral, 200.0, 2.9, 1.59e-4},
        Row{Stability::kNeutral, 400.0, 1.8, 1.49e-4},
        Row{Stability::kNeutral, 600.0, 1.4, 1.42e-4}, Row{Stability::kStable, 200.0, 1.6, 9.18e-4},
        Row{Stability::kStable, 400.0, 1.0, 8.59e-4},
        Row{Stability::kStable, 600.0, 0.8, 8.27e-4}}) {
    const ExponentialEvolution e = fit_kaimal(scaled(row.stability, row.evolution_s)).evolution;
    expect_within(0.1, e.decay, row.decay, "a_x");
    expect_within(0.1, e.offset_per_m, row.offset_per_m, "b_x");
  }
}

// GUO Table 1, unstable.
TEST(TurbulenceFit, MeetsTheFirstPublishedTable) {
  const KaimalModel found = fit_kaimal(scaled(Stability::kUnstable, 600.0)).model;
  const KaimalModel printed = stability_kaimal(Stability::kUnstable, kStabilitySigmaU_mps);
  expect_within(0.02, found.u.length_scale_m, printed.u.length_scale_m, "L_u");
  expect_within(0.02, found.v.length_scale_m, printed.v.length_scale_m, "L_v");
  expect_within(0.02, found.w.length_scale_m, printed.w.length_scale_m, "L_w");
  expect_within(0.02, found.u.sigma_mps, printed.u.sigma_mps, "sigma_u");
  expect_within(0.02, found.v.sigma_mps, printed.v.sigma_mps, "sigma_v");
  expect_within(0.07, found.w.sigma_mps, printed.w.sigma_mps, "sigma_w");
  expect_within(0.02, found.coherence_decay, printed.coherence_decay, "a_yz");
  expect_within(0.05, found.coherence_length_m, printed.coherence_length_m, "L_c");
}

// The stable row: spectra of u, and lengths. Its sigma_v, sigma_w (found 2.48, 2.08, printed 2.26,
// 1.83) look exchanged with the unstable ones (2.34, 1.98); its L_c is printed with the digits of
// L_u, and with a_yz gives a coherence that the tensor does not have.
TEST(TurbulenceFit, MeetsTheStableRowWhereItIsOfTheTensor) {
  const KaimalModel found = fit_kaimal(scaled(Stability::kStable, 200.0)).model;
  const KaimalModel printed = stability_kaimal(Stability::kStable, kStabilitySigmaU_mps);
  expect_within(0.1, found.u.length_scale_m, printed.u.length_scale_m, "L_u");
  expect_within(0.1, found.v.length_scale_m, printed.v.length_scale_m, "L_v");
  expect_within(0.1, found.w.length_scale_m, printed.w.length_scale_m, "L_w");
  expect_within(0.02, found.u.sigma_mps, printed.u.sigma_mps, "sigma_u");
  expect_within(0.06, found.v.sigma_mps, 2.34, "sigma_v of the unstable row");
  expect_within(0.06, found.w.sigma_mps, 1.98, "sigma_w of the unstable row");
  const double k1 = 1e-4;
  const MannTensor tensor(scaled(Stability::kStable, 200.0));
  const double cocoh =
      tensor.cross_spectra(k1, {20.0, 20.0, 0.0})[kUu].real() / tensor.spectra(k1)[kUu];
  const double r_m = std::hypot(20.0, 20.0), f_hz = k1 / (2.0 * kPi);
  EXPECT_NEAR(found.root_coherence(r_m, f_hz, 1.0), cocoh, 0.03);
  EXPECT_GT(std::abs(printed.root_coherence(r_m, f_hz, 1.0) - cocoh), 0.03);
}

TEST(TurbulenceFit, RefusesFrozenTurbulence) {
  MannParams frozen = stability_mann(Stability::kNeutral);
  frozen.evolution_s = std::numeric_limits<double>::infinity();
  EXPECT_THROW(fit_kaimal(frozen), Error);
}

}  // namespace
}  // namespace lac::sim
