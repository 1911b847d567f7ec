// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/mann_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/wind/iec_wind.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

class MannCaseTest : public ::testing::Test {
 protected:
  WindCase read(const std::string& keys) {
    YamlReader in =
        YamlReader::load(folder_.write("wind.yaml", "kind: mann\nmean_speed_mps: 16\n" + keys));
    WindCase wind = read_wind(in, {90.0, 63.0, 5});
    in.finish();
    return wind;
  }
  MannWind mann(const std::string& keys) { return std::get<MannWind>(read(keys).source); }
  std::string error_of(const std::string& keys) {
    try {
      read(keys);
    } catch (const Error& e) {
      return e.what();
    }
    return "none";
  }

  test::TempFolder folder_;
};

double sigma_u(const MannParams& p) {
  return std::sqrt(MannTensor(p).covariance()[kUu]);
}

// Without more: IEC's model (Gamma 3.9, L = 0.8 * 42 m), sigma_u of the class, frozen.
TEST_F(MannCaseTest, Defaults) {
  const MannWind wind = mann("");
  EXPECT_EQ(wind.field.model.lifetime, EddyLifetime::kMann);
  EXPECT_DOUBLE_EQ(wind.field.model.length_m, 33.6);
  EXPECT_EQ(wind.field.model.gamma, 3.9);
  EXPECT_NEAR(sigma_u(wind.field.model), 0.16 * (0.75 * 16.0 + 5.6), 1e-9);
  EXPECT_EQ(wind.field.seed, 5U);
  EXPECT_TRUE(wind.planes_m.empty());
}

// A stability class, scaled to the standard deviation asked for; single numbers may be replaced.
TEST_F(MannCaseTest, StabilityClasses) {
  const MannWind stable = mann("stability: stable\nturbulence_category: B\n");
  EXPECT_EQ(stable.field.model.length_m, 30.0);
  EXPECT_EQ(stable.field.model.low_slope, -0.8);
  EXPECT_NEAR(sigma_u(stable.field.model), 0.14 * (0.75 * 16.0 + 5.6), 1e-9);
  const MannWind other =
      mann("stability: unstable\nsigma_u_mps: 1.5\nlength_scale_m: 100\nanisotropy: 2\n");
  EXPECT_NEAR(sigma_u(other.field.model), 1.5, 1e-9);
  EXPECT_EQ(other.field.model.length_m, 100.0);
  EXPECT_EQ(other.field.model.gamma, 2.0);
}

// Grid, box and evolution arrive; the time scale is that of the class unless given.
TEST_F(MannCaseTest, GridAndEvolution) {
  const MannWind wind = mann(
      "stability: stable\npoints_across: 9\nbox_points_across: 30\nsmall_eddies: cut\n"
      "rescale: yes\nevolution: {planes_m: [50, 100]}\n");
  EXPECT_EQ(wind.field.ny, 9);
  EXPECT_EQ(wind.field.box_ny, 30);
  EXPECT_EQ(wind.field.small_eddies, SmallEddies::kCut);
  EXPECT_TRUE(wind.field.rescale);
  EXPECT_EQ(wind.planes_m, (std::vector{50.0, 100.0}));
  EXPECT_EQ(wind.field.model.evolution_s, 200.0);
  const MannWind slow = mann("evolution: {planes_m: [50], time_scale_s: 700}\n");
  EXPECT_EQ(slow.field.model.evolution_s, 700.0);
}

const char* const kSmall =
    "points_across: 5\npoints_up: 5\ntime_step_s: 0.5\nperiod_s: 32\nshear_exponent: 0.2\n";

// What is made: one plane, or several that differ; veer is given to each of them.
TEST_F(MannCaseTest, Fields) {
  const WindCase frozen = read(kSmall);
  const auto one = make_wind(frozen);
  EXPECT_NE(dynamic_cast<const GriddedWind*>(one.get()), nullptr);
  const WindCase evolving = read(std::string(kSmall) + "evolution: {planes_m: [60]}\n");
  const auto two = make_wind(evolving);
  EXPECT_EQ(dynamic_cast<const EvolvingWind&>(*two).layout().size(), 2U);
  const Vec3 rotor{0.0, 0.0, 55.0}, ahead{-64.0, 0.0, 55.0};  // on the grid
  EXPECT_EQ(two->velocity(rotor, 9.0), one->velocity(rotor, 9.0));
  EXPECT_NE(two->velocity(ahead, 5.0), two->velocity(rotor, 9.0));
  const auto turned =
      make_wind(read(std::string(kSmall) + "evolution: {planes_m: [60]}\nveer_deg_per_m: 0.5\n"));
  const Vec3 plain = two->velocity(ahead, 5.0), veered = turned->velocity(ahead, 5.0);
  const double turn_rad = rad_from_deg(0.5 * (55.0 - 90.0));
  EXPECT_NEAR(veered.x, std::cos(turn_rad) * plain.x + std::sin(turn_rad) * plain.y, 1e-5);
  EXPECT_NEAR(veered.y, -std::sin(turn_rad) * plain.x + std::cos(turn_rad) * plain.y, 1e-5);
  EXPECT_EQ(plain.z, veered.z);
}

// The line for reports.
TEST_F(MannCaseTest, Description) {
  EXPECT_EQ(describe(read("stability: neutral\nsigma_u_mps: 2\nevolution: {planes_m: [50, 80]}\n")),
            "Mann turbulence, 16 m/s, alpha eps^(2/3) 0.1624, L 49 m, Gamma 3.1 (lifetime of Guo), "
            "27 x 27 points, seed 5, evolving with 400 s in 2 planes up to 80 m");
}

// At the greatest time scale that is allowed the wind is there, and frozen to rounding.
TEST_F(MannCaseTest, LongestTimeScale) {
  const auto wind =
      make_wind(read(std::string(kSmall) + "evolution: {planes_m: [60], time_scale_s: 1e9}\n"));
  const Vec3 rotor{0.0, 0.0, 55.0}, ahead{-64.0, 0.0, 55.0};
  EXPECT_LT(norm(wind->velocity(ahead, 5.0) - wind->velocity(rotor, 9.0)), 0.02);
}

// What the period leaves of sigma_u: a table made by an independent route, the fields themselves.
TEST_F(MannCaseTest, HeldTurbulence) {
  const MannWind wind = mann(std::string(kSmall) + "sigma_u_mps: 2\n");
  const SigmaU sigma = sigma_u(wind);
  EXPECT_NEAR(sigma.asked_mps, 2.0, 1e-9);
  MannFieldParams field = wind.field;
  double sum = 0.0;
  constexpr int kSeeds = 60;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    field.seed = static_cast<std::uint64_t>(seed);
    const GriddedWind drawn = make_mann_field(field);
    const double mean_mps = 16.0;  // at the hub
    for (int it = 0; it < 64; ++it)
      sum += std::pow(drawn.grid().at(it, 2, 2, 0) - mean_mps, 2) / (64.0 * kSeeds);
  }
  // A variance of some ten independent harmonics per seed: 4 standard errors are about 15 %.
  EXPECT_NEAR(sum / (sigma.held_mps * sigma.held_mps), 1.0, 0.15);
  EXPECT_LT(sigma.held_mps, 1.9);
  EXPECT_THAT(held_turbulence(read(std::string(kSmall) + "sigma_u_mps: 2\n")),
              HasSubstr("m/s, asked for 2 m/s: what is slower than its period"));
  EXPECT_EQ(held_turbulence(read(std::string(kSmall) + "sigma_u_mps: 2\nrescale: yes\n")), "");
}

// Faults, each with its key.
TEST_F(MannCaseTest, Faults) {
  EXPECT_THAT(error_of("stability: wild\n"), HasSubstr("stability: found 'wild'"));
  EXPECT_THAT(error_of("anisotropy: -1\n"), HasSubstr("anisotropy"));
  EXPECT_THAT(error_of("evolution: {planes_m: [80, 50]}\n"),
              HasSubstr("evolution.planes_m: expected distances that rise"));
  EXPECT_THAT(error_of("evolution: {planes_m: [50], gamma: 4}\n"), HasSubstr("gamma"));
  EXPECT_THAT(error_of("evolution: {time_scale_s: 4}\n"), HasSubstr("planes_m"));
  EXPECT_THAT(error_of("evolution: {planes_m: [50], time_scale_s: 1e39}\n"),
              HasSubstr("wind.yaml:3: evolution.time_scale_s: found 1e39, expected a number above "
                        "0 up to 1000000000"));
  EXPECT_THAT(
      error_of("box_points_across: 31\n"),
      HasSubstr("wind.yaml:3: box_points_across: found 31, expected an even number, at least "
                "points_across = 27"));
  EXPECT_THAT(error_of("box_points_up: 20\n"), HasSubstr("box_points_up: found 20, expected an "));
  EXPECT_THAT(error_of("period_s: 100.05\n"), HasSubstr("wind.yaml:3: period_s: found 100.05"));
  EXPECT_THAT(error_of("lateral_coherence: independent\n"), HasSubstr("lateral_coherence"));
}

}  // namespace
}  // namespace lac::sim
