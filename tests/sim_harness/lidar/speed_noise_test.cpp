// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/speed_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

constexpr int kDraws = 100000;

// Fixed sigma; white and Gaussian: variance, correlation with the last draw and fourth moment
// within 4.5 standard errors.
TEST(SpeedNoise, WhiteAndGaussian) {
  SpeedNoise noise({.sigma_mps = 0.3}, 1);
  double square = 0.0, fourth = 0.0, product = 0.0, before = 0.0;
  for (int k = 0; k < kDraws; ++k) {
    const double v = noise.draw_mps(-40.0) / 0.3;
    square += v * v;
    fourth += v * v * v * v;
    product += v * before;
    before = v;
  }
  EXPECT_NEAR(square / kDraws, 1.0, 4.5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(product / kDraws, 0.0, 4.5 / std::sqrt(kDraws));
  EXPECT_NEAR(fourth / kDraws, 3.0, 4.5 * std::sqrt(96.0 / kDraws));
}

// Twice sigma at the given CNR, sigma far above, ten times more per 10 dB far below.
TEST(SpeedNoise, GrowsAsTheSignalFades) {
  const SpeedNoise noise({.sigma_mps = 0.1, .doubling_cnr_db = -15.0}, 1);
  EXPECT_DOUBLE_EQ(noise.sigma_mps(-15.0), 0.2);
  EXPECT_NEAR(noise.sigma_mps(30.0), 0.1, 1e-5);
  EXPECT_NEAR(noise.sigma_mps(-65.0) / noise.sigma_mps(-55.0), 10.0, 1e-3);
}

// The approximation as it is published: sigma^2 = sqrt(8) dv^2 (1 + alpha/sqrt(2 pi))^2 / (alpha
// Np), alpha = SNR B/(sqrt(2 pi) dv), Np = SNR n M; dv = 1.5 m/s, B = 40 m/s, n M = 1e5.
TEST(SpeedNoise, RyeAndHardesty) {
  const double root = std::sqrt(2.0 * kPi), width = 1.5, bandwidth = 40.0, count = 1e5;
  const auto published = [&](double snr) {
    const double alpha = snr * bandwidth / (root * width);
    return std::sqrt(std::sqrt(8.0) / (alpha * snr * count)) * width * (1.0 + alpha / root);
  };
  const SpeedNoise noise({.sigma_mps = published(1e9),
                          .doubling_cnr_db = 10.0 * std::log10(2.0 * kPi * width / bandwidth)},
                         1);
  for (const double db : {-30.0, -17.0, -6.3, 0.0, 20.0}) {
    const double expected = published(std::pow(10.0, 0.1 * db));
    EXPECT_NEAR(noise.sigma_mps(db), expected, 1e-6 * expected) << db;
  }
}

TEST(SpeedNoise, Keys) {
  const test::TempFolder folder;
  YamlReader in =
      YamlReader::load(folder.write("a.yaml", "{sigma_mps: 0.1, doubling_cnr_db: -12}"));
  const SpeedNoiseParams p = read_speed_noise(in);
  in.finish();
  EXPECT_EQ(p.sigma_mps, 0.1);
  EXPECT_EQ(p.doubling_cnr_db, -12.0);
  EXPECT_FALSE(SpeedNoise({}, 1).enabled());
}

}  // namespace
}  // namespace lac::sim
