// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/rotor_signals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "sim_harness/analysis/statistics.hpp"
#include "sim_harness/wind/kaimal_field.hpp"
#include "sim_harness/wind/uniform_wind.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

RotorWindParams rotor(double t_end_s, double dt_s) {
  RotorWindParams params;
  params.t_end_s = t_end_s;
  params.dt_s = dt_s;
  return params;
}

// Linear shears are found as they are, in both directions and with a changing gust on top: EWS at
// its height has A (1 - cos) / D = 7.56 2 / 126 = 0.12 m/s per m.
TEST(RotorSignals, ShearsOfAPlane) {
  for (const auto axis : {ShearEvent::Axis::kVertical, ShearEvent::Axis::kHorizontal}) {
    UniformWindParams params;
    params.history = ShearEvent{18.0, 7.56, axis, 2.0};
    const RotorSignals s = rotor_signals(UniformWind(params), rotor(10.0, 1.0), 5.0);
    const bool vertical = axis == ShearEvent::Axis::kVertical;
    EXPECT_NEAR((vertical ? s.shear_z_per_s : s.shear_y_per_s)[8], 0.12, 1e-12);
    EXPECT_NEAR((vertical ? s.shear_y_per_s : s.shear_z_per_s)[8], 0.0, 1e-12);
    EXPECT_NEAR(s.rews_mps[8], 18.0, 1e-12);
    EXPECT_EQ(s.point_count, 497u);
  }
}

// Without shear the disk is one point; its slopes are 0.
TEST(RotorSignals, OnePoint) {
  const RotorSignals s = rotor_signals(UniformWind(UniformWindParams{}), rotor(10.0, 1.0), 5.0);
  EXPECT_EQ(s.point_count, 1u);
  EXPECT_EQ(s.shear_y_per_s[3], 0.0);
  EXPECT_EQ(s.shear_z_per_s[3], 0.0);
  EXPECT_EQ(s.intensity[10], 0.0);
}

// A power law: the slope at the hub is U a / z_hub to first order; over the 63 m disk the third
// order adds c3 (z/z_h)^3, whose best slope is c3 <z^4> / <z^2> / z_h^3 = c3 R^2 / (2 z_h^3).
TEST(RotorSignals, ShearOfAPowerLaw) {
  UniformWindParams params;
  params.history = SteadySpeed{10.0};
  params.shear_exponent = 0.2;
  const RotorSignals s = rotor_signals(UniformWind(params), rotor(2.0, 1.0), 2.0);
  const double a = 0.2, c3 = a * (a - 1) * (a - 2) / 6, c5 = c3 * (a - 3) * (a - 4) / 20;
  const double q = std::pow(63.0 / 90.0, 2);
  const double expected = 10.0 / 90.0 * (a + c3 * q / 2 + c5 * q * q * 5.0 / 16.0);
  EXPECT_NEAR(s.shear_z_per_s[0], expected, 0.005 * expected);
}

// A sine of whole periods in the window has the standard deviation A sqrt(n / (2 (n - 1))), over
// the mean U, at every sample once the window is full, and nothing before.
TEST(RotorSignals, IntensityOfASine) {
  UniformTable table;
  for (int i = 0; i <= 200; ++i)
    table.rows.push_back({0.5 * i, {.speed_mps = 10.0 + 2.0 * std::sin(kPi * i / 20.0)}});
  UniformWindParams params;
  params.history = table;
  const RotorSignals s = rotor_signals(UniformWind(params), rotor(100.0, 0.5), 40.0);
  const double expected = 2.0 * std::sqrt(80.0 / (2.0 * 79.0)) / 10.0;
  for (std::size_t k = 0; k < s.intensity.size(); ++k) {
    if (k < 79) {
      EXPECT_TRUE(std::isnan(s.intensity[k])) << k;
    } else {
      EXPECT_NEAR(s.intensity[k], expected, 1e-9) << k;
    }
  }
}

// In turbulence: the last value of the running window against the plain statistics of the same
// samples point by point, and the least-squares slope against the normal equations, which on this
// symmetric disk are sum(y u) / sum(y^2).
TEST(RotorSignals, TurbulenceAgainstPlainStatistics) {
  KaimalFieldParams p;
  p.ny = p.nz = 9;
  p.width_m = p.height_m = 126.0;
  p.dt_s = 0.5;
  p.duration_s = 128.0;
  p.shear_exponent = 0.2;
  const GriddedWind wind = make_kaimal_field(p);
  const RotorSignals s = rotor_signals(wind, rotor(100.0, 0.5), 60.0);
  double sigma = 0.0, mean = 0.0, uy = 0.0, yy = 0.0;
  for (const DiskPoint& point : wind.disk_points(90.0, 63.0)) {
    std::vector<double> u;
    for (int k = 81; k <= 200; ++k)
      u.push_back(wind.velocity({0.0, point.y_m, point.z_m}, 0.5 * k).x);
    const Statistics st = statistics(u);
    sigma += st.standard_deviation;
    mean += st.mean;
    uy += point.y_m * u.back();
    yy += point.y_m * point.y_m;
  }
  EXPECT_NEAR(s.intensity[200], sigma / mean, 1e-9);
  EXPECT_NEAR(s.shear_y_per_s[200], uy / yy, 1e-9);
}

// A window of one sample, and a rotor outside of the field.
TEST(RotorSignals, Refuses) {
  const UniformWind wind(UniformWindParams{});
  EXPECT_THAT(test::error_text([&] { rotor_signals(wind, rotor(10.0, 1.0), 1.0); }),
              ::testing::HasSubstr("rotor signals: window [s] = 1, expected two samples"));
  const GriddedWind small(VelocityGrid({9, 9, 11, 10.0, 10.0, 1.0, 27.0, 90.0, 18.0, false}));
  EXPECT_THAT(test::error_text([&] { rotor_signals(small, rotor(10.0, 1.0), 5.0); }),
              ::testing::HasSubstr("where the wind field"));
}

}  // namespace
}  // namespace lac::sim
