// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/carrier_to_noise.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

CarrierToNoiseParams params() {
  CarrierToNoiseParams p;
  p.enabled = true;
  p.reference_db = -10.0;
  return p;
}

// Collimated and without a Rayleigh length 1/R^2: 6.02 dB from 100 to 200 m; extinction of 0.2 per
// km costs 2 * 0.2 * 0.1 nepers = 0.1737 dB more.
TEST(CarrierToNoise, InverseSquare) {
  CarrierToNoiseParams p = params();
  const CarrierToNoise clear(p, 1);
  EXPECT_NEAR(clear.mean_db(100.0), -10.0, 1e-12);
  EXPECT_NEAR(clear.mean_db(200.0), -10.0 - 20.0 * std::log10(2.0), 1e-12);
  p.extinction_per_km = 0.2;
  EXPECT_NEAR(CarrierToNoise(p, 1).mean_db(200.0) - clear.mean_db(200.0), -0.1737178, 1e-6);
}

// Focused: largest at F z0^2 / (F^2 + z0^2); at the focus itself 1/R^2 alone is left.
TEST(CarrierToNoise, Focus) {
  CarrierToNoiseParams p = params();
  p.focus_range_m = 150.0;
  p.rayleigh_length_m = 400.0;
  p.reference_range_m = 150.0;
  const CarrierToNoise c(p, 1);
  const double best_m = 150.0 * 400.0 * 400.0 / (150.0 * 150.0 + 400.0 * 400.0);
  EXPECT_GT(c.mean_db(best_m), c.mean_db(best_m - 1.0));
  EXPECT_GT(c.mean_db(best_m), c.mean_db(best_m + 1.0));
  // at 50 m: 50^2 + (400 * 2/3)^2 against 150^2
  EXPECT_NEAR(c.mean_db(50.0), -10.0 - 10.0 * std::log10((2500.0 + 71111.1111) / 22500.0), 1e-6);
}

// Share of detected gates over range: Phi((mean - threshold) / sqrt(scatter^2 + drift^2)), within
// 4.5 standard errors (false alarm below 1e-5 each). Drift forgets itself between the draws.
TEST(CarrierToNoise, AvailabilityFallsWithRange) {
  CarrierToNoiseParams p = params();
  p.scatter_db = 2.0;
  p.drift_db = 1.5;
  p.drift_time_s = 1.0;
  p.threshold_db = -14.0;
  constexpr int kDraws = 40000;
  for (const double range_m : {80.0, 120.0, 158.5, 250.0}) {
    CarrierToNoise c(p, 5);
    int seen = 0;
    for (int k = 0; k < kDraws; ++k) {
      c.move_on(20.0 * k);
      seen += c.detects(c.draw_db(range_m));
    }
    const double s = (c.mean_db(range_m) + 14.0) / 2.5;
    const double expected = 0.5 * std::erfc(-s / std::sqrt(2.0));
    const double error = std::sqrt(expected * (1.0 - expected) / kDraws);
    EXPECT_NEAR(static_cast<double>(seen) / kDraws, expected, 4.5 * error) << range_m;
  }
}

// The drift: standard deviation drift_db, correlation exp(-t / drift_time), the same at all gates;
// standard errors of an autoregression with that memory.
TEST(CarrierToNoise, Drift) {
  CarrierToNoiseParams p = params();
  p.drift_db = 3.0;
  p.drift_time_s = 10.0;
  CarrierToNoise c(p, 7);
  constexpr int kDraws = 100000;
  const double rho = std::exp(-0.2);  // every 2 s
  double square = 0.0, product = 0.0, before = 0.0;
  for (int k = 0; k < kDraws; ++k) {
    c.move_on(2.0 * k);
    const double d = c.draw_db(100.0) + 10.0;
    EXPECT_NEAR(c.draw_db(50.0) - c.draw_db(100.0), 20.0 * std::log10(2.0), 1e-12);
    square += d * d;
    product += d * before;
    before = d;
  }
  const double relative_error =
      std::sqrt(2.0 / kDraws * (1.0 + rho * rho) / (1.0 - rho * rho));  // of a variance
  EXPECT_NEAR(square / kDraws, 9.0, 4.5 * 9.0 * relative_error);
  EXPECT_NEAR(product / square, rho, 4.5 * std::sqrt((1.0 - rho * rho) / kDraws));
}

// It starts in its steady state: over many seeds the first value has the same standard deviation.
TEST(CarrierToNoise, DriftFromTheStart) {
  CarrierToNoiseParams p = params();
  p.drift_db = 3.0;
  constexpr int kSeeds = 4000;
  double square = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    CarrierToNoise c(p, static_cast<std::uint64_t>(seed));
    c.move_on(0.25);
    square += std::pow(c.draw_db(100.0) + 10.0, 2);
  }
  EXPECT_NEAR(square / kSeeds, 9.0, 4.5 * 9.0 * std::sqrt(2.0 / kSeeds));
}

// Same seed, same values; another seed, others.
TEST(CarrierToNoise, Seeds) {
  CarrierToNoiseParams p = params();
  p.scatter_db = 1.0;
  CarrierToNoise a(p, 3), b(p, 3), c(p, 4);
  const double first = a.draw_db(100.0);
  EXPECT_EQ(first, b.draw_db(100.0));
  EXPECT_NE(first, c.draw_db(100.0));
}

TEST(CarrierToNoise, Keys) {
  const test::TempFolder folder;
  const auto read = [&](const std::string& text) {
    YamlReader in = YamlReader::load(folder.write("a.yaml", text));
    const CarrierToNoiseParams p = read_carrier_to_noise(in);
    in.finish();
    return p;
  };
  const CarrierToNoiseParams p = read(
      "{reference_db: -8, threshold_db: -17, reference_range_m: 120, focus_range_m: 150, "
      "rayleigh_length_m: 400, extinction_per_km: 0.1, scatter_db: 2, drift_db: 1, "
      "drift_time_s: 300}");
  EXPECT_TRUE(p.enabled);
  EXPECT_EQ(p.threshold_db, -17.0);
  EXPECT_EQ(p.focus_range_m, 150.0);
  EXPECT_EQ(p.drift_time_s, 300.0);
  const CarrierToNoiseParams c = read("{reference_db: 8, threshold_db: 5, over_range: constant}");
  EXPECT_EQ(CarrierToNoise(c, 1).mean_db(10.0), 8.0);
  EXPECT_EQ(CarrierToNoise(c, 1).mean_db(180.0), 8.0);
  EXPECT_THAT(test::error_text([&] { read("reference_db: -8\n"); }),
              ::testing::HasSubstr("threshold_db: the key is missing"));
}

// The keys of the range may stay when it no longer counts; keys without effect are refused.
TEST(CarrierToNoise, KeysWithoutEffect) {
  const test::TempFolder folder;
  const auto error_of = [&](const std::string& more) {
    return test::error_text([&] {
      YamlReader in = YamlReader::load(
          folder.write("a.yaml", "{reference_db: -5, threshold_db: -17, " + more + "}"));
      read_carrier_to_noise(in);
      in.finish();
    });
  };
  const std::string range =
      "reference_range_m: 150, focus_range_m: 150, rayleigh_length_m: 400, extinction_per_km: 0.1";
  EXPECT_EQ(error_of(range), "no error");
  EXPECT_EQ(error_of("over_range: constant, " + range), "no error");
  EXPECT_THAT(error_of("over_range: constant, extinction_per_km: -1"),
              ::testing::HasSubstr("extinction_per_km: found -1"));
  EXPECT_THAT(error_of("focus_range_m: 150"),
              ::testing::HasSubstr("focus_range_m: has no effect without rayleigh_length_m"));
  EXPECT_THAT(error_of("drift_time_s: 60"),
              ::testing::HasSubstr("drift_time_s: there is no drift_db"));
  EXPECT_EQ(error_of("drift_time_s: 60, drift_db: 0"), "no error");
}

}  // namespace
}  // namespace lac::sim
