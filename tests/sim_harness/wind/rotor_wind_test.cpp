// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/rotor_wind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "sim_harness/wind/kaimal_field.hpp"
#include "sim_harness/wind/uniform_wind.hpp"

namespace lac::sim {
namespace {

RotorWindParams rotor(double t_begin_s, double t_end_s, double dt_s) {
  RotorWindParams params;
  params.t_begin_s = t_begin_s;
  params.t_end_s = t_end_s;
  params.dt_s = dt_s;
  return params;
}

// A uniform gust is its own mean: exact at the samples, from a negative start to the end.
TEST(RotorWind, UniformWindIsExact) {
  UniformWindParams params;
  params.history = GustSpeed{18.0, 7.0, 0.0};
  const UniformWind wind(params);
  const RotorWind rews(wind, rotor(-20.0, 20.0, 0.25));
  EXPECT_EQ(rews.point_count(), 1u);
  EXPECT_EQ(rews.samples_mps().size(), 161u);
  for (int i = -80; i <= 80; ++i)
    EXPECT_EQ(rews.at(0.25 * i), wind.velocity({0.0, 0.0, 90.0}, 0.25 * i).x) << i;
}

// Straight lines between samples; the ends hold.
TEST(RotorWind, LinearBetweenSamples) {
  UniformWindParams params;
  params.history = StepSpeed{10.0, 14.0, 1.0, 2.0};
  const RotorWind rews(UniformWind(params), rotor(0.0, 4.0, 1.0));
  EXPECT_DOUBLE_EQ(rews.at(1.25), 10.5);
  EXPECT_DOUBLE_EQ(rews.at(2.75), 13.5);
  EXPECT_EQ(rews.at(4.0), 14.0);
  EXPECT_EQ(rews.at(99.0), 14.0);
  EXPECT_EQ(rews.at(-99.0), 10.0);
}

// A power law over the disk: series of (1 + z/z_hub)^a over the circle, even moments
// <z^2> = R^2/4, <z^4> = R^4/8, <z^6> = 5 R^6/64. A 5 m raster meets it to 1e-4; it has as many
// points as there are lattice points in a circle of radius 12.6 (497).
TEST(RotorWind, ShearedProfile) {
  UniformWindParams params;
  params.history = SteadySpeed{1.0};
  params.shear_exponent = 0.2;
  const RotorWind rews(UniformWind(params), rotor(0.0, 1.0, 1.0));
  const double a = 0.2, q = std::pow(63.0 / 90.0, 2);
  const double c2 = a * (a - 1) / 2, c4 = c2 * (a - 2) * (a - 3) / 12,
               c6 = c4 * (a - 4) * (a - 5) / 30;
  const double expected = 1.0 + c2 * q / 4 + c4 * q * q / 8 + c6 * 5 * q * q * q / 64;
  EXPECT_NEAR(rews.at(0.0), expected, 1e-4);
  EXPECT_EQ(rews.point_count(), 497u);
}

/// 9 x 9 points 15.75 m apart, so that the 63 m rotor has grid points on its rim.
KaimalFieldParams field() {
  KaimalFieldParams p;
  p.ny = p.nz = 9;
  p.width_m = p.height_m = 126.0;
  p.dt_s = 0.5;
  p.duration_s = 128.0;
  p.threads = 1;
  return p;
}

// On a grid the mean is that of the points within the radius at every step, and linear in between.
TEST(RotorWind, GriddedFieldUsesItsOwnPoints) {
  const GriddedWind wind = make_kaimal_field(field());
  const RotorWind rews(wind, rotor(-10.0, 20.0, 0.5));
  double sum = 0.0;
  int count = 0;
  for (int iz = 0; iz < 9; ++iz) {
    for (int iy = 0; iy < 9; ++iy) {
      if ((iz - 4) * (iz - 4) + (iy - 4) * (iy - 4) > 16) continue;
      sum += wind.grid().at(7, iz, iy, 0);
      ++count;
    }
  }
  EXPECT_EQ(count, 49);
  EXPECT_EQ(rews.point_count(), 49u);
  EXPECT_NEAR(rews.at(3.5), sum / count, 1e-6);
  EXPECT_NEAR(rews.at(3.6), 0.8 * rews.at(3.5) + 0.2 * rews.at(4.0), 1e-12);
}

/// Methods section 4: S_RR = S_u / n^2 sum over pairs of gamma(r_ij), here integrated over a bin.
double rews_bin_variance(const KaimalFieldParams& p, const std::vector<DiskPoint>& points, int m) {
  double sum = 0.0;
  for (const DiskPoint& a : points) {
    for (const DiskPoint& b : points) {
      sum += p.model.root_coherence(std::hypot(a.y_m - b.y_m, a.z_m - b.z_m), m / p.duration_s,
                                    p.mean_speed_mps);
    }
  }
  const double n = static_cast<double>(points.size()), df_hz = 1.0 / p.duration_s;
  return sum / n / n * p.model.u.variance((m - 0.5) * df_hz, (m + 0.5) * df_hz, p.mean_speed_mps);
}

// Variance of the REWS over 100 seeds against the same sum of theory over the same points: within 4
// standard errors (23 %; false alarm 6e-5). Without coherence it would be 19 times smaller.
TEST(RotorWind, VarianceAgreesWithTheory) {
  constexpr int kSeeds = 100;
  KaimalFieldParams p = field();
  double found = 0.0, expected = 0.0, error_squared = 0.0;
  std::vector<DiskPoint> points;
  for (p.seed = 1; p.seed <= kSeeds; ++p.seed) {
    const GriddedWind wind = make_kaimal_field(p);
    points = wind.disk_points(90.0, 63.0);
    const RotorWind rews(wind, rotor(0.0, 127.5, 0.5));
    for (double u : rews.samples_mps()) found += std::pow(u - 18.0, 2) / 256 / kSeeds;
  }
  for (int m = 1; m <= 128; ++m) {
    const double variance = rews_bin_variance(p, points, m);
    expected += variance;
    error_squared += variance * variance / kSeeds;
  }
  EXPECT_NEAR(found, expected, 4.0 * std::sqrt(error_squared));
}

void expect_refused(const WindField& wind, const RotorWindParams& params, const char* text) {
  try {
    RotorWind rews(wind, params);
    FAIL() << text << " was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(text));
  }
}

// A rotor or a time outside of the field is refused at set-up.
TEST(RotorWind, RefusesWhatLeavesTheField) {
  const GriddedWind wind(VelocityGrid({9, 9, 11, 15.75, 15.75, 1.0, 27.0, 90.0, 18.0, false}));
  RotorWindParams params = rotor(0.0, 10.0, 1.0);
  EXPECT_NO_THROW(RotorWind(wind, params));
  params.radius_m = 64.0;
  expect_refused(wind, params,
                 "right edge of the rotor [m] = -64, expected at least -63, where the wind field");
  params = rotor(0.0, 10.0, 1.0);
  params.hub_height_m = 91.0;
  expect_refused(wind, params, "greatest height of the rotor [m] = 154");
  expect_refused(wind, rotor(-1.0, 10.0, 1.0), "t_begin_s = -1");
  expect_refused(wind, rotor(0.0, 11.0, 1.0), "last sample [s] = 11");
  expect_refused(wind, rotor(0.0, 10.0, 0.0), "dt_s = 0");
  params.radius_m = 1.0;
  params.hub_height_m = 98.0;
  expect_refused(wind, params, "number of points in the disk = 0");
}

}  // namespace
}  // namespace lac::sim
