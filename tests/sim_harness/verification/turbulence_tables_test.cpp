// SPDX-License-Identifier: Apache-2.0
// The models themselves against numbers of python/turbulence_models.py, which shares no code with
// them: spectra of u, v, w, coherence at five separations across and three along the wind, uw. The
// tables in tests/data/turbulence have the command in the first line.
#include <gtest/gtest.h>

#include <string>

#include "core/mann_tensor.hpp"
#include "core/units.hpp"
#include "sim_harness/wind/stability.hpp"
#include "tests/sim_harness/verification/frequency_table.hpp"

namespace lac::sim {
namespace {

constexpr double kSpeed_mps = 16.0;
constexpr double kSeparations_m[] = {10.0, 20.0, 40.0, 80.0, 160.0};
constexpr double kDistances_m[] = {50.0, 100.0, 170.0};
constexpr std::size_t kColumns = 23;
constexpr struct Class {
  Stability stability;
  const char* name;
} kClasses[] = {{Stability::kUnstable, "unstable"},
                {Stability::kNeutral, "neutral"},
                {Stability::kStable, "stable"}};

FrequencyTable table(const std::string& model, const Class& c) {
  return {LAC_SOURCE_DIR "/tests/data/turbulence/" + model + "_" + c.name + ".txt", kColumns};
}

// Mann, three classes: spectra to 1e-4, coherence to 3e-3 where the nodes of
// cross_spectra() resolve the separation (k1 r < 6).
TEST(TurbulenceTables, Mann) {
  for (const Class& c : kClasses) {
    const MannTensor tensor(stability_mann(c.stability));
    const FrequencyTable theory = table("mann", c);
    for (std::size_t i = 1; i < theory.rows().size(); i += 6) {
      const auto& row = theory.rows()[i];
      const double k1_radpm = 2.0 * kPi * row[0] / kSpeed_mps;
      const SpectralTensor f = tensor.spectra(k1_radpm);
      for (int component = 0; component < 3; ++component) {
        EXPECT_NEAR(f[component] * 4.0 * kPi / kSpeed_mps / row[1 + component], 1.0, 1e-4);
      }
      for (int s = 0; s < 5; ++s) {
        if (k1_radpm * kSeparations_m[s] > 6.0) continue;
        const CrossSpectra cross = tensor.cross_spectra(k1_radpm, {kSeparations_m[s], 0.0, 0.0});
        for (int component = 0; component < 3; ++component)
          EXPECT_NEAR(cross[component].real() / f[component], row[4 + 5 * component + s], 3e-3);
      }
      std::size_t column = 19;
      for (const double distance_m : kDistances_m) {
        const CrossSpectra later =
            tensor.cross_spectra(k1_radpm, {0.0, 0.0, distance_m / kSpeed_mps});
        EXPECT_NEAR(later[kUu].real() / f[kUu], row[column++], 1e-4);
      }
      EXPECT_NEAR(f[kUw] / std::sqrt(f[kUu] * f[kWw]), row[column], 1e-4);
    }
  }
}

// Kaimal, three classes.
TEST(TurbulenceTables, Kaimal) {
  for (const Class& c : kClasses) {
    const KaimalModel model = stability_kaimal(c.stability, kStabilitySigmaU_mps);
    const ExponentialEvolution evolution = stability_evolution(c.stability);
    const FrequencyTable theory = table("kaimal", c);
    for (const auto& row : theory.rows()) {
      EXPECT_NEAR(model.u.spectrum(row[0], kSpeed_mps) / row[1], 1.0, 1e-5);
      EXPECT_NEAR(model.v.spectrum(row[0], kSpeed_mps) / row[2], 1.0, 1e-5);
      EXPECT_NEAR(model.w.spectrum(row[0], kSpeed_mps) / row[3], 1.0, 1e-5);
      for (int s = 0; s < 5; ++s)
        EXPECT_NEAR(model.root_coherence(kSeparations_m[s], row[0], kSpeed_mps), row[4 + s], 1e-5);
      for (int d = 0; d < 3; ++d) {
        EXPECT_NEAR(evolution.root_coherence(kDistances_m[d], row[0], kSpeed_mps), row[19 + d],
                    1e-5);
      }
    }
  }
}

}  // namespace
}  // namespace lac::sim
