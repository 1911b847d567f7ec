// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/induction_zone.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "sim_harness/lidar/induced_wind.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

constexpr double kRadius_m = 63.0;

/// Biot and Savart's law over the cylinder: closed along x, trapezoidal rule around, which
/// converges exponentially for a periodic integrand.
UnitInduction quadrature(double x, double r) {
  constexpr int kPoints = 20000;
  const double R = kRadius_m;
  UnitInduction sum;
  for (int i = 0; i < kPoints; ++i) {
    const double c = std::cos(2.0 * kPi * (i + 0.5) / kPoints);
    const double across_square = R * R + r * r - 2.0 * R * r * c;
    const double far = std::sqrt(x * x + across_square);
    sum.axial += R * (R - r * c) / across_square * (1.0 + x / far);
    sum.radial += R * c / far;
  }
  return {sum.axial / kPoints, sum.radial / kPoints};
}

// Above 8/9 the tangent of C_T = 4 a (1 - a) at a = 1/3.
TEST(InductionZone, FactorOfThrust) {
  EXPECT_DOUBLE_EQ(induction_factor(0.0), 0.0);
  EXPECT_NEAR(induction_factor(4.0 * 0.25 * 0.75), 0.25, 1e-15);
  EXPECT_NEAR(induction_factor(8.0 / 9.0), 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(induction_factor(8.0 / 9.0 + 0.4), 1.0 / 3.0 + 0.3, 1e-15);
  EXPECT_LT(induction_factor(-0.1), 0.0);
}

// On the axis both models are 1 + xi / sqrt(1 + xi^2): a in the rotor plane, none far up-wind,
// two far down-wind.
TEST(InductionZone, OnTheAxis) {
  for (const double x : {-500.0, -170.0, -50.0, -1.0, 0.0, 80.0}) {
    const double expected = 1.0 + x / kRadius_m / std::sqrt(1.0 + x * x / kRadius_m / kRadius_m);
    EXPECT_NEAR(one_dimensional_induction(x, kRadius_m).axial, expected, 1e-14);
    const UnitInduction u = vortex_cylinder_induction(x, 0.0, kRadius_m);
    EXPECT_NEAR(u.axial, expected, 1e-14);
    EXPECT_NEAR(u.radial, 0.0, 1e-14);
  }
  EXPECT_DOUBLE_EQ(one_dimensional_induction(0.0, kRadius_m).axial, 1.0);
  EXPECT_NEAR(vortex_cylinder_induction(1e6, 0.0, kRadius_m).axial, 2.0, 1e-8);
  EXPECT_NEAR(vortex_cylinder_induction(-1e6, 0.0, kRadius_m).axial, 0.0, 1e-8);
}

// Off the axis, on both sides of the rotor and of the rim.
TEST(InductionZone, CylinderAgainstBiotSavart) {
  const double places[][2] = {{-50, 30}, {-50, 62}, {-50, 64}, {-20, 80}, {-100, 61},
                              {-5, 62},  {30, 20},  {30, 90},  {-170, 61}};
  for (const auto& p : places) {
    const UnitInduction u = vortex_cylinder_induction(p[0], p[1], kRadius_m);
    const UnitInduction expected = quadrature(p[0], p[1]);
    EXPECT_NEAR(u.axial, expected.axial, 1e-11) << p[0] << ' ' << p[1];
    EXPECT_NEAR(u.radial, expected.radial, 1e-11) << p[0] << ' ' << p[1];
  }
}

// The rotor plane: a everywhere inside the disk, nothing outside. Ahead of the rim the velocity is
// continuous, although each of the two parts it is made of jumps.
TEST(InductionZone, RotorPlaneAndRim) {
  EXPECT_DOUBLE_EQ(vortex_cylinder_induction(0.0, 40.0, kRadius_m).axial, 1.0);
  EXPECT_DOUBLE_EQ(vortex_cylinder_induction(0.0, 70.0, kRadius_m).axial, 0.0);
  const double at_rim = vortex_cylinder_induction(-5.0, kRadius_m, kRadius_m).axial;
  for (const double off_m : {-1e-5, -1e-9, 1e-9, 1e-5}) {
    EXPECT_NEAR(vortex_cylinder_induction(-5.0, kRadius_m + off_m, kRadius_m).axial, at_rim, 1e-6);
  }
}

// On the rim itself, where the radial velocity grows without bound as a logarithm, the answer is
// finite: (log(4/kc) - 2)/pi at kc = 1e-9.
TEST(InductionZone, OnTheRim) {
  const UnitInduction u = vortex_cylinder_induction(0.0, kRadius_m, kRadius_m);
  EXPECT_NEAR(u.radial, (std::log(4.0 / 1e-9) - 2.0) / kPi, 1e-6);
  EXPECT_TRUE(std::isfinite(u.axial));
}

// Mass: what enters a cylinder through its front leaves through its back and its side.
TEST(InductionZone, MassIsKept) {
  const double r = 45.0, front = -150.0, back = -10.0;
  constexpr int kSteps = 2000;
  double through = 0.0, sideways = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double s = (i + 0.5) / kSteps;
    const double ring = 2.0 * kPi * s * r * r / kSteps;
    through += ring * (vortex_cylinder_induction(back, s * r, kRadius_m).axial -
                       vortex_cylinder_induction(front, s * r, kRadius_m).axial);
    const double x = front + s * (back - front);
    sideways +=
        vortex_cylinder_induction(x, r, kRadius_m).radial * 2.0 * kPi * r * (back - front) / kSteps;
  }
  EXPECT_NEAR(sideways, through, 1e-5 * through);
  EXPECT_GT(through, 1000.0);
}

/// 12 m/s, 2 m/s from the right, everywhere.
class OneWind final : public WindField {
 public:
  Vec3 velocity(const Vec3&, double) const override { return {12.0, 2.0, 0.0}; }
  double mean_speed_mps() const override { return 10.0; }
};

// The wind of a field: slowed along x, pushed away from the axis, counted from the rotor centre.
TEST(InducedWind, AddsToTheFreeWind) {
  const OneWind free;
  InductionParams p;
  p.model = InductionModel::kVortexCylinder;
  p.thrust_coefficient = 0.75;  // a = 1/4
  InducedWind wind(free, p, kRadius_m);
  wind.follow(0.0, {0.5, 0.0, 90.0}, 0.0125);
  const UnitInduction unit = vortex_cylinder_induction(-50.5, 50.0, kRadius_m);
  const Vec3 u = wind.velocity({-50.0, 30.0, 50.0}, 7.0);  // 30 to the left, 40 below the axis
  EXPECT_NEAR(u.x, 12.0 - 3.0 * unit.axial, 1e-12);
  EXPECT_NEAR(u.y, 2.0 + 3.0 * unit.radial * 0.6, 1e-12);
  EXPECT_NEAR(u.z, -3.0 * unit.radial * 0.8, 1e-12);
  EXPECT_GT(unit.radial, 0.0);
}

// C_T of the turbine through a first-order low-pass: 1 - 1/e of a step after one time constant.
TEST(InductionZone, FollowsTheThrust) {
  InductionParams p;
  p.model = InductionModel::kOneDimensional;
  p.follows_thrust = true;
  p.time_constant_s = 2.0;
  InductionZone zone(p, kRadius_m, 10.0);
  zone.advance(0.5, 0.01);
  EXPECT_DOUBLE_EQ(zone.induction_factor(), induction_factor(0.5));
  for (int i = 0; i < 200; ++i) zone.advance(0.8, 0.01);
  EXPECT_NEAR(zone.induction_factor(), induction_factor(0.8 - 0.3 * std::exp(-1.0)), 1e-12);
}

// Without a time constant of its own: 1.1 R/U.
TEST(InductionZone, TimeConstantOfDynamicInflow) {
  InductionParams p;
  p.model = InductionModel::kOneDimensional;
  p.follows_thrust = true;
  InductionZone zone(p, kRadius_m, 11.0);
  zone.advance(0.0, 0.01);
  for (int i = 0; i < 630; ++i) zone.advance(0.8, 0.01);
  EXPECT_NEAR(zone.induction_factor(), induction_factor(0.8 * (1.0 - std::exp(-1.0))), 1e-12);
}

InductionParams read(const std::string& text) {
  const test::TempFolder folder;
  YamlReader in = YamlReader::load(folder.write("a.yaml", text));
  const InductionParams p = read_induction(in);
  in.finish();
  return p;
}

TEST(InductionZone, Keys) {
  EXPECT_EQ(read("model: none\n").model, InductionModel::kNone);
  EXPECT_EQ(read("{model: vortex_cylinder, thrust_coefficient: 0.5}").thrust_coefficient, 0.5);
  const InductionParams p =
      read("{model: one_dimensional, thrust_coefficient: turbine, time_constant_s: 3}");
  EXPECT_EQ(p.model, InductionModel::kOneDimensional);
  EXPECT_TRUE(p.follows_thrust);
  EXPECT_EQ(p.time_constant_s, 3.0);
  EXPECT_THAT(test::error_text([] { read("{model: vortex_cylinder, thrust_coefficient: 2}"); }),
              ::testing::HasSubstr("a.yaml:1: thrust_coefficient: found 2, expected"));
}

// Switched off with the keys of a case that has it on; they are still checked. A time constant is
// above 0, and a number that does not change has none.
TEST(InductionZone, SwitchedOff) {
  const test::TempFolder folder;
  const auto error_of = [&](const std::string& text) {
    return test::error_text([&] {
      YamlReader in = YamlReader::load(folder.write("a.yaml", text));
      EXPECT_FALSE(InductionZone(read_induction(in), 63.0, 18.0).active());
      in.finish();
    });
  };
  EXPECT_EQ(error_of("{model: none, thrust_coefficient: turbine, time_constant_s: 3}"), "no error");
  EXPECT_EQ(error_of("{model: none, thrust_coefficient: 0.7}"), "no error");
  EXPECT_EQ(error_of("{model: none}"), "no error");
  EXPECT_THAT(error_of("{model: none, thrust_coefficient: 7}"),
              ::testing::HasSubstr("thrust_coefficient: found 7"));
  EXPECT_THAT(error_of("{model: none, time_constant_s: 0}"),
              ::testing::HasSubstr("time_constant_s: found 0"));
  EXPECT_THAT(error_of("{model: one_dimensional, thrust_coefficient: turbine, time_constant_s: 0}"),
              ::testing::HasSubstr("time_constant_s: found 0"));
  EXPECT_THAT(error_of("{model: one_dimensional, thrust_coefficient: 0.7, time_constant_s: 3}"),
              ::testing::HasSubstr("time_constant_s: expected thrust_coefficient: turbine"));
}

}  // namespace
}  // namespace lac::sim
