// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/kaimal_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim_harness/wind/iec_wind.hpp"
#include "sim_harness/wind/stability.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

class KaimalCaseTest : public ::testing::Test {
 protected:
  WindCase read(const std::string& keys) {
    YamlReader in =
        YamlReader::load(folder_.write("wind.yaml", "kind: kaimal\nmean_speed_mps: 16\n" + keys));
    WindCase wind = read_wind(in, {90.0, 63.0, 5});
    in.finish();
    return wind;
  }
  KaimalWind kaimal(const std::string& keys) { return std::get<KaimalWind>(read(keys).source); }
  std::string error_of(const std::string& keys) {
    return test::error_text([&] { read(keys); });
  }

  test::TempFolder folder_;
};

// Without more: IEC's model, sigma of the class, v and w independent, frozen.
TEST_F(KaimalCaseTest, Defaults) {
  const KaimalWind wind = kaimal("");
  const double sigma_u_mps = 0.16 * (0.75 * 16.0 + 5.6);
  EXPECT_DOUBLE_EQ(wind.field.model.u.sigma_mps, sigma_u_mps);
  EXPECT_DOUBLE_EQ(wind.field.model.w.sigma_mps, 0.5 * sigma_u_mps);
  EXPECT_DOUBLE_EQ(wind.field.model.v.length_scale_m, 2.7 * 42.0);
  EXPECT_EQ(wind.field.model.coherence_decay, 12.0);
  EXPECT_DOUBLE_EQ(wind.field.model.coherence_length_m, 8.1 * 42.0);
  EXPECT_EQ(wind.field.lateral_coherence, LateralCoherence::kIndependent);
  EXPECT_EQ(wind.field.seed, 5U);
  EXPECT_TRUE(wind.planes_m.empty());
}

// A stability class is GUO's Table 1, scaled to the standard deviation asked for.
TEST_F(KaimalCaseTest, StabilityClasses) {
  const KaimalModel unstable = kaimal("stability: unstable\nsigma_u_mps: 1.41\n").field.model;
  EXPECT_DOUBLE_EQ(unstable.u.sigma_mps, 1.41);
  EXPECT_DOUBLE_EQ(unstable.v.sigma_mps, 1.17);
  EXPECT_EQ(unstable.w.length_scale_m, 126.4);
  EXPECT_EQ(unstable.coherence_decay, 6.5);
  EXPECT_EQ(unstable.coherence_length_m, 1502.0);
  EXPECT_EQ(kaimal("stability: stable\n").field.model.u.length_scale_m, 101.1);
  EXPECT_EQ(kaimal("stability: neutral\n").field.model.u.length_scale_m, 340.2);
}

// Single numbers may be replaced; those left out stay those of the class.
TEST_F(KaimalCaseTest, FreeParameters) {
  const KaimalModel model = kaimal(
                                "stability: stable\nsigma_u_mps: 2\nsigma_ratios: [0.7, 0.4]\n"
                                "length_scales_m: [300, 100, 20]\ncoherence_decay: 8\n"
                                "coherence_length_m: 250\nlateral_coherence: same_as_u\n")
                                .field.model;
  EXPECT_DOUBLE_EQ(model.u.sigma_mps, 2.0);
  EXPECT_DOUBLE_EQ(model.v.sigma_mps, 1.4);
  EXPECT_DOUBLE_EQ(model.w.sigma_mps, 0.8);
  EXPECT_EQ(model.u.length_scale_m, 300.0);
  EXPECT_EQ(model.v.length_scale_m, 100.0);
  EXPECT_EQ(model.w.length_scale_m, 20.0);
  EXPECT_EQ(model.coherence_decay, 8.0);
  EXPECT_EQ(model.coherence_length_m, 250.0);
  EXPECT_EQ(kaimal("coherence_decay: 8\n").field.model.coherence_length_m, 8.1 * 42.0);
}

// Evolution is that of the class (GUO Table 2; iec: neutral) unless given.
TEST_F(KaimalCaseTest, Evolution) {
  const auto evolution = [&](const std::string& keys) { return kaimal(keys).field.evolution; };
  const KaimalWind stable = kaimal("stability: stable\nevolution: {planes_m: [50, 100]}\n");
  EXPECT_EQ(stable.planes_m, (std::vector{50.0, 100.0}));
  EXPECT_EQ(stable.field.evolution.decay, 1.6);
  EXPECT_EQ(stable.field.evolution.offset_per_m, 9.18e-4);
  EXPECT_EQ(evolution("evolution: {planes_m: [50]}\n").decay, 1.8);
  EXPECT_EQ(evolution("stability: unstable\nevolution: {planes_m: [50]}\n").decay, 4.1);
  const auto given = evolution("evolution: {planes_m: [50], decay: 3, offset_per_m: 0}\n");
  EXPECT_EQ(given.decay, 3.0);
  EXPECT_EQ(given.offset_per_m, 0.0);
}

const char* const kSmall =
    "points_across: 5\npoints_up: 5\ntime_step_s: 0.5\nperiod_s: 32\nshear_exponent: 0.2\n";

// What is made: one plane, or several that differ; the first is the frozen field; the shape is
// given to each of them.
TEST_F(KaimalCaseTest, Fields) {
  const WindCase frozen = read(kSmall);
  const WindCase evolving = read(std::string(kSmall) + "evolution: {planes_m: [60]}\n");
  EXPECT_FALSE(evolves(frozen));
  EXPECT_TRUE(evolves(evolving));
  const auto one = make_wind(frozen), two = make_wind(evolving);
  EXPECT_NE(dynamic_cast<const GriddedWind*>(one.get()), nullptr);
  const Vec3 rotor{0.0, 0.0, 55.0}, ahead{-64.0, 0.0, 55.0};  // on the grid
  EXPECT_EQ(two->velocity(rotor, 9.0), one->velocity(rotor, 9.0));
  EXPECT_NE(two->velocity(ahead, 5.0), two->velocity(rotor, 9.0));
  const auto scaled = make_wind(
      read(std::string(kSmall) + "evolution: {planes_m: [60]}\nfluctuation_scale: [1, 2, 1]\n"));
  EXPECT_NEAR(scaled->velocity(rotor, 9.0).y, 2.0 * two->velocity(rotor, 9.0).y, 0.2);
  EXPECT_NEAR(scaled->velocity(ahead, 5.0).x, two->velocity(ahead, 5.0).x, 1e-5);
}

// The line for reports.
TEST_F(KaimalCaseTest, Description) {
  EXPECT_EQ(describe(read("stability: unstable\nsigma_u_mps: 1.41\nshear_exponent: 0.1\n"
                          "lateral_coherence: same_as_u\nevolution: {planes_m: [50, 80]}\n")),
            "Kaimal turbulence, 16 m/s, sigma 1.41, 1.17, 0.99 m/s, L 744.8, 181.9, 126.4 m, "
            "coherence 6.5, 1502 m (right to 1e-07), v and w coherent as u, 27 x 27 points, seed "
            "5, shear exponent 0.1, evolving with 4.1, 7.67e-05 /m in 2 planes up to 80 m");
}

// What period and step leave of sigma_u, by hand: with a = 6 L / U = 127.575 s it is
// sqrt((1 + a 0.5/660)^(-2/3) - (1 + a 3300.5/660)^(-2/3)) = 0.962740 of what is asked for; a long
// and fine field holds what it should, and nothing is said.
TEST_F(KaimalCaseTest, HeldTurbulence) {
  const SigmaU sigma = sigma_u(kaimal("sigma_u_mps: 3\n"));
  EXPECT_EQ(sigma.asked_mps, 3.0);
  EXPECT_NEAR(sigma.held_mps, 3.0 * 0.962740, 3e-6);
  EXPECT_EQ(
      held_turbulence(read("sigma_u_mps: 3\n")),
      "note: the wind is expected to hold sigma_u = 2.89 m/s, asked for 3 m/s: what is slower "
      "than its period or faster than its time step is left out\n");
  EXPECT_EQ(held_turbulence(read("period_s: 6600\n")), "");
  EXPECT_EQ(held_turbulence(WindCase{UniformWindParams{}}), "");
}

// Faults, each with its key.
TEST_F(KaimalCaseTest, Faults) {
  EXPECT_THAT(error_of("stability: wild\n"), HasSubstr("stability: found 'wild'"));
  EXPECT_THAT(error_of("length_scales_m: [300, 100]\n"),
              HasSubstr("wind.yaml:3: length_scales_m: expected three numbers, for u, v and w"));
  EXPECT_THAT(error_of("length_scales_m: [300, 100, 0]\n"), HasSubstr("length_scales_m"));
  EXPECT_THAT(error_of("sigma_ratios: [1, 0.8, 0.5]\n"),
              HasSubstr("sigma_ratios: expected two numbers, v and w over u"));
  EXPECT_THAT(error_of("coherence_decay: 0\n"), HasSubstr("coherence_decay"));
  EXPECT_THAT(error_of("shear_exponent: -0.1\n"), HasSubstr("wind.yaml:3: shear_exponent"));
  EXPECT_THAT(error_of("evolution: {decay: 2}\n"), HasSubstr("evolution.planes_m: missing"));
  EXPECT_THAT(error_of("evolution: {planes_m: [50], decay: 0}\n"), HasSubstr("evolution.decay"));
  EXPECT_THAT(error_of("evolution: {planes_m: [50], time_scale_s: 400}\n"),
              HasSubstr("time_scale_s"));
  EXPECT_THAT(error_of("period_s: 100.05\n"),
              HasSubstr("wind.yaml:3: period_s: found 100.05, expected a multiple of time_step_s = "
                        "0.1"));
  EXPECT_THAT(error_of("period_s: 0.7\n"),
              HasSubstr("wind.yaml:3: period_s: found 0.7, expected 8 to 100000000 times"));
  EXPECT_THAT(
      error_of("height_m: 181\n"),
      HasSubstr("wind.yaml:3: height_m: found 181, expected at most twice the hub height of "
                "90 m"));
  EXPECT_THAT(error_of("height_m: 180\nperiod_s: 0.8\n"), HasSubstr("no error"));
  EXPECT_THAT(error_of("anisotropy: 3\n"), HasSubstr("anisotropy"));
}

}  // namespace
}  // namespace lac::sim
