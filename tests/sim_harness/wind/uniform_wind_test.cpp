// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/uniform_wind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/wind/iec_wind.hpp"

namespace lac::sim {
namespace {

double u_at(const WindField& field, double x_m, double time_s, double z_m = 90.0) {
  return field.velocity({x_m, 3.0, z_m}, time_s).x;
}

UniformWindParams with(const UniformHistory& history) {
  UniformWindParams params;
  params.history = history;
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

/// Turned clockwise seen from above, the wind blows to the right, towards -y.
void expect_direction(const Vec3& wind, double speed_mps, double angle_deg) {
  EXPECT_NEAR(wind.x, speed_mps * std::cos(rad_from_deg(angle_deg)), 1e-9);
  EXPECT_NEAR(wind.y, -speed_mps * std::sin(rad_from_deg(angle_deg)), 1e-9);
  EXPECT_EQ(wind.z, 0.0);
}

// EDC: half of the angle after half of the 6 s, then the new direction for good, in both senses.
TEST(UniformWind, DirectionChange) {
  for (const double sign : {1.0, -1.0}) {
    const UniformWind wind(with(DirectionChange{18.0, sign * rad_from_deg(30.0), 60.0}));
    expect_direction(wind.velocity({0.0, 5.0, 90.0}, 60.0), 18.0, 0.0);
    expect_direction(wind.velocity({0.0, 5.0, 90.0}, 63.0), 18.0, sign * 15.0);
    expect_direction(wind.velocity({0.0, 5.0, 90.0}, 66.0), 18.0, sign * 30.0);
    expect_direction(wind.velocity({-36.0, 5.0, 90.0}, 600.0), 18.0, sign * 30.0);
  }
}

// ECD at 10 m/s: 72 deg and 15 m/s within 10 s; the gust is the same at all heights, the profile
// is not (0.5^0.2 at 45 m).
TEST(UniformWind, CoherentGust) {
  UniformWindParams params = with(CoherentGust{10.0, 15.0, ecd_angle_rad(10.0), 60.0});
  params.shear_exponent = 0.2;
  const UniformWind wind(params);
  const double low_mps = 10.0 * std::pow(0.5, 0.2);
  expect_direction(wind.velocity({0.0, 0.0, 45.0}, 60.0), low_mps, 0.0);
  expect_direction(wind.velocity({0.0, 0.0, 45.0}, 65.0), low_mps + 7.5, 36.0);
  expect_direction(wind.velocity({0.0, 0.0, 90.0}, 71.0), 25.0, 72.0);
  EXPECT_EQ(wind.mean_speed_mps(), 10.0);
}

// EWS: at T/2 the speed at the upper (left) rim is A higher, at the lower (right) rim A lower than
// at the hub; with the other sign the other way round; nothing before and after.
TEST(UniformWind, ExtremeShear) {
  const double a_mps = 7.648;
  for (const double sign : {1.0, -1.0}) {
    const UniformWind vertical(
        with(ShearEvent{18.0, sign * a_mps, ShearEvent::Axis::kVertical, 60.0}));
    EXPECT_NEAR(vertical.velocity({0.0, 9.0, 153.0}, 66.0).x, 18.0 + sign * a_mps, 1e-9);
    EXPECT_NEAR(vertical.velocity({0.0, 9.0, 27.0}, 66.0).x, 18.0 - sign * a_mps, 1e-9);
    EXPECT_EQ(vertical.velocity({0.0, 9.0, 153.0}, 60.0).x, 18.0);
    const UniformWind horizontal(
        with(ShearEvent{18.0, sign * a_mps, ShearEvent::Axis::kHorizontal, 60.0}));
    EXPECT_NEAR(horizontal.velocity({0.0, 63.0, 9.0}, 63.0).x, 18.0 + 0.5 * sign * a_mps, 1e-9);
    EXPECT_NEAR(horizontal.velocity({0.0, -63.0, 9.0}, 66.0).x, 18.0 - sign * a_mps, 1e-9);
    EXPECT_EQ(horizontal.velocity({0.0, 63.0, 9.0}, 72.0).x, 18.0);
    EXPECT_GT(horizontal.disk_points(90.0, 63.0).size(), 400u);
  }
}

// A table row with everything in it, by hand after InflowWind's equation at y = 20, z = 120, L =
// 126: V1 = 12 (1.333333^0.2 + (0.1 20 cos 30 + 0.3 30) / 126) + 1.5 = 15.232786; upflow 8 deg:
// horizontal cos 8 V1 - sin 8 0.5 = 15.014955, vertical sin 8 V1 + cos 8 0.5 = 2.615128; direction
// 30 deg: (13.003333, -7.507478).
TEST(UniformWind, TableRowAsInflowWindReadsIt) {
  const UniformState state{12.0, rad_from_deg(30.0), 0.5, 0.1, 0.2, 0.3, 1.5, rad_from_deg(8.0)};
  const UniformWind wind(with(UniformTable{{{0.0, state}}}));
  const Vec3 v = wind.velocity({0.0, 20.0, 120.0}, 7.0);
  EXPECT_NEAR(v.x, 13.003333, 1e-6);
  EXPECT_NEAR(v.y, -7.507478, 1e-6);
  EXPECT_NEAR(v.z, 2.615128, 1e-6);
  EXPECT_EQ(wind.extent().z_min_m, 0.0);
  EXPECT_EQ(wind.mean_speed_mps(), 12.0);
}

// Straight lines between rows, the first and the last row beyond.
TEST(UniformWind, TableOverTime) {
  UniformTable table{{{10.0, {.speed_mps = 8.0}}, {12.0, {.speed_mps = 12.0, .gust_mps = 2.0}}}};
  const UniformWind wind(with(table));
  EXPECT_EQ(u_at(wind, 0.0, -5.0), 8.0);
  EXPECT_EQ(u_at(wind, 0.0, 10.0), 8.0);
  EXPECT_DOUBLE_EQ(u_at(wind, 0.0, 11.5), 11.0 + 1.5);
  EXPECT_EQ(u_at(wind, 0.0, 12.0), 14.0);
  EXPECT_EQ(u_at(wind, 0.0, 1e9), 14.0);
  EXPECT_EQ(u_at(wind, -16.0, 10.0), 14.0);
}

// A tabulated event keeps the rows that matter: 20 s of nothing, 6 s of turning, nothing again.
TEST(UniformWind, Tabulate) {
  const UniformTable table =
      tabulate(UniformWind(with(DirectionChange{18.0, 1.0, 20.0})), 0.0, 100.0, 0.5);
  ASSERT_EQ(table.rows.size(), 15u);
  EXPECT_EQ(table.rows[1].time_s, 20.0);
  EXPECT_EQ(table.rows[13].time_s, 26.0);
  EXPECT_EQ(table.rows[14].time_s, 100.0);
  EXPECT_NEAR(table.rows[7].state.direction_rad, 0.5, 1e-12);
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
  expect_refused(with(DirectionChange{0.0, 0.5, 60.0}), "direction change: mean_speed_mps = 0");
  expect_refused(with(CoherentGust{10.0, NAN, 0.5, 60.0}), "gust_mps = nan");
  expect_refused(with(ShearEvent{10.0, INFINITY}), "amplitude_mps = inf");
  expect_refused(with(UniformTable{}), "uniform wind table: rows = 0");
  expect_refused(with(UniformTable{{{1.0, {5.0}}, {1.0, {5.0}}}}), "time_s = 1, expected later");
  UniformWindParams params;
  params.advection_speed_mps = std::nan("");
  expect_refused(params, "advection_speed_mps = nan");
}

}  // namespace
}  // namespace lac::sim
