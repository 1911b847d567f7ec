// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/uniform_wind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"

namespace lac::sim {
namespace {

double u_at(const WindField& field, double x_m, double time_s, double z_m = 90.0) {
  return field.velocity({x_m, 3.0, z_m}, time_s).x;
}

UniformWindParams with(const SpeedHistory& speed) {
  UniformWindParams params;
  params.speed = speed;
  return params;
}

// The gust of class IA at 18 m/s on the NREL 5 MW rotor: peak, and mean before and after.
TEST(UniformWind, OperatingGust) {
  const double gust_mps = eog_magnitude_mps({}, 18.0, 90.0, 126.0);
  const UniformWind wind(with(GustSpeed{18.0, gust_mps, 60.0}));
  EXPECT_NEAR(u_at(wind, 0.0, 65.25), 18.0 + 0.74 * gust_mps, 1e-12);
  EXPECT_EQ(u_at(wind, 0.0, 60.0), 18.0);
  EXPECT_EQ(u_at(wind, 0.0, 70.5), 18.0);
  EXPECT_EQ(u_at(wind, 0.0, -1000.0), 18.0);
}

// Taylor: what is 36 m up-wind at 18 m/s arrives two seconds later, exactly.
TEST(UniformWind, TravelsWithTheMeanSpeed) {
  const UniformWind wind(with(GustSpeed{18.0, 7.0, 60.0}));
  for (int i = 220; i < 300; ++i)
    EXPECT_EQ(u_at(wind, -36.0, 0.25 * i), u_at(wind, 0.0, 0.25 * i + 2.0)) << i;
}

// The step arrives at its time, jumps without a ramp and is a straight line with one.
TEST(UniformWind, StepAndRamp) {
  const UniformWind step(with(StepSpeed{10.0, 12.0, 60.0, 0.0}));
  EXPECT_EQ(u_at(step, 0.0, 59.999), 10.0);
  EXPECT_EQ(u_at(step, 0.0, 60.0), 12.0);
  EXPECT_EQ(u_at(step, -100.0, 50.0), 12.0);
  const UniformWind ramp(with(StepSpeed{10.0, 12.0, 60.0, 4.0}));
  EXPECT_EQ(u_at(ramp, 0.0, 61.0), 10.5);
  EXPECT_EQ(u_at(ramp, 0.0, 64.0), 12.0);
}

// The speed before the step carries it unless another is given.
TEST(UniformWind, AdvectionSpeed) {
  UniformWindParams params = with(StepSpeed{10.0, 12.0, 60.0, 0.0});
  EXPECT_EQ(UniformWind(params).mean_speed_mps(), 10.0);
  params.advection_speed_mps = 20.0;
  EXPECT_EQ(u_at(UniformWind(params), -20.0, 58.9), 10.0);
  EXPECT_EQ(u_at(UniformWind(params), -20.0, 59.0), 12.0);
}

// Power law on the mean; the gust is the same at all heights (IEC 61400-1, 6.3.2.2).
TEST(UniformWind, ShearActsOnTheMeanOnly) {
  UniformWindParams params = with(GustSpeed{18.0, 10.0, 60.0});
  params.shear_exponent = 0.5;
  const UniformWind wind(params);
  EXPECT_DOUBLE_EQ(u_at(wind, 0.0, 0.0, 22.5), 9.0);
  EXPECT_DOUBLE_EQ(u_at(wind, 0.0, 65.25, 22.5), 9.0 + 7.4);
  EXPECT_EQ(wind.extent().z_min_m, 0.0);
}

// Steady wind has no bounds, no side components and one point for the disk.
TEST(UniformWind, SteadyIsTheSameEverywhere) {
  const UniformWind wind(with(SteadySpeed{8.0}));
  EXPECT_EQ(wind.velocity({-300.0, 1e3, -5.0}, 1e6), (Vec3{8.0, 0.0, 0.0}));
  EXPECT_EQ(wind.time_end_s(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(wind.disk_points(90.0, 63.0).size(), 1u);
}

void expect_refused(const UniformWindParams& params, const char* name) {
  try {
    UniformWind wind(params);
    FAIL() << name << " was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(name));
  }
}

// What cannot be flown is refused by name.
TEST(UniformWind, RefusesBadParameters) {
  expect_refused(with(SteadySpeed{0.0}), "speed_mps = 0");
  expect_refused(with(StepSpeed{10.0, -1.0, 60.0, 0.0}), "to_mps = -1");
  expect_refused(with(StepSpeed{10.0, 12.0, 60.0, -1.0}), "ramp_s = -1");
  expect_refused(with(GustSpeed{60.0, -5.4, 60.0}), "magnitude_mps = -5.4");
  UniformWindParams params;
  params.advection_speed_mps = std::nan("");
  expect_refused(params, "advection_speed_mps = nan");
}

}  // namespace
}  // namespace lac::sim
