// SPDX-License-Identifier: Apache-2.0
// LDP behind the simulated lidar: what it takes out against what is there.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/units.hpp"
#include "ldp/ldp.hpp"
#include "sim_harness/lidar/induced_wind.hpp"
#include "sim_harness/lidar/lidar_sim.hpp"
#include "sim_harness/wind/kaimal_field.hpp"
#include "sim_harness/wind/turned_wind.hpp"
#include "sim_harness/wind/uniform_wind.hpp"
#include "tests/sim_harness/lidar/function_wind.hpp"
#include "tests/sim_harness/lidar/rough_sea.hpp"

namespace lac {
namespace {

using namespace sim;

constexpr double kStep_s = 0.0125;
constexpr double kHub_m = 90.0;
constexpr double kRadius_m = 63.0;

/// Points, unless a range weighting is asked for: what a model says, without what a volume adds.
LidarParams four_beams(double fwhm_m = 0.0) {
  LidarParams p;
  p.weighting.fwhm_m = fwhm_m;
  const double a = rad_from_deg(14.4), e = rad_from_deg(14.0);
  p.scan.beams = {{a, e, 0.0, {}}, {a, -e, 0.0, {}}, {-a, -e, 0.0, {}}, {-a, e, 0.0, {}}};
  p.gates_m = {50.0, 63.3, 76.7, 90.0, 103.3, 116.7, 130.0, 143.3, 156.7, 170.0};
  p.gates_along_beam = false;
  return p;
}

LdpParams processing(WindModel model, double window_s) {
  LdpParams p;
  p.reader.number_of_beams = 4;
  p.wind.model = model;
  p.wind.window_s = window_s;
  p.wind.hub_height_m = kHub_m;
  p.wind.rotor_radius_m = kRadius_m;
  return p;
}

Ldp::Outputs fly(const LdpParams& params, LidarSim& lidar, double end_s) {
  const Ldp ldp(params, kStep_s);
  Ldp::State state = ldp.initial_state();
  Ldp::Outputs out;
  LidarMeasurement m;
  for (int n = 0; n * kStep_s < end_s; ++n) {
    Ldp::Inputs in;
    in.time_s = n * kStep_s;
    if (lidar.step(n, {}, m)) in.measurement = &m;
    out = ldp.step(in, state);
  }
  return out;
}

Vec3 sheared(const Vec3& p, double) {
  return {10.0 + 0.012 * p.y + 0.03 * (p.z - kHub_m), 1.5, -0.4};
}

// A platform that moves in all six ways, a lidar beside and behind the hub, tilted: the linear
// field comes back to the curvature of one motion over one beam time, which here is none.
TEST(LdpSimulated, FloatingPlatform) {
  const test::FunctionWind wind(sheared);
  LidarParams lidar_params = four_beams();
  lidar_params.mounting.offset_m = {2.0, 0.5, 2.5};
  lidar_params.mounting.tilt_rad = rad_from_deg(4.0);
  lidar_params.platform = rough_sea(rad_from_deg(5.0));
  LidarSim lidar(lidar_params, wind, {kHub_m, kStep_s, 130.0});
  const auto out = fly(processing(WindModel::All, 60.0), lidar, 120.0);
  EXPECT_EQ(out.wind.reason, WindReason::Complete);
  EXPECT_NEAR(out.wind.u_mps, 10.0, 1e-9);
  EXPECT_NEAR(out.wind.v_mps, 1.5, 1e-9);
  EXPECT_NEAR(out.wind.w_mps, -0.4, 1e-9);
  EXPECT_NEAR(out.wind.du_dy_per_s, 0.012, 1e-11);
  EXPECT_NEAR(out.wind.du_dz_per_s, 0.03, 1e-11);
  EXPECT_NEAR(out.rews_mps, 10.0, 2e-6);  // of the hub, though the beams look elsewhere
  EXPECT_NEAR(out.wind.inflow_angle_rad, std::atan2(-0.4, std::hypot(10.0, 1.5)), 1e-9);

  // The average alone takes shear, v and w for u.
  LidarSim again(lidar_params, wind, {kHub_m, kStep_s, 130.0});
  EXPECT_GT(std::abs(fly(processing(WindModel::U, 60.0), again, 120.0).rews_mps - 10.0), 0.05);
}

// A turned nacelle that says so: the yaw error is wind direction minus nacelle direction.
TEST(LdpSimulated, YawErrorOfATurnedNacelle) {
  const test::FunctionWind wind(+[](const Vec3&, double) { return Vec3{10.0, 1.0, 0.0}; });
  LidarParams p = four_beams();
  p.platform.freedoms[kYaw].mean = rad_from_deg(12.0);
  LidarSim lidar(p, wind, {kHub_m, kStep_s, 40.0});
  const auto out = fly(processing(WindModel::UV, 20.0), lidar, 30.0);
  EXPECT_NEAR(out.wind.yaw_error_rad, std::atan2(1.0, 10.0) - rad_from_deg(12.0), 1e-9);
}

// The induction zone of the simulation is undone by the same model, with its radial part, and by
// the other one not quite: for beams that cross the axis axial and radial part make up for each
// other, 1 mm/s are left.
TEST(LdpSimulated, InductionIsUndone) {
  UniformWindParams steady;
  steady.history = SteadySpeed{11.0};
  const UniformWind free(steady);
  for (const InductionModel model :
       {InductionModel::kOneDimensional, InductionModel::kVortexCylinder}) {
    InductionParams zone;
    zone.model = model;
    zone.thrust_coefficient = 0.75;
    InducedWind wind(free, zone, kRadius_m);
    wind.follow(0.75, {0.0, 0.0, kHub_m}, kStep_s);
    const auto estimate = [&](InductionModel assumed) {
      LidarParams lidar_params = four_beams();
      lidar_params.mounting.tilt_rad = rad_from_deg(3.0);
      LidarSim lidar(lidar_params, wind, {kHub_m, kStep_s, 50.0});
      LdpParams p = processing(WindModel::U, 60.0);
      p.induction = {assumed,  LookupTable({3.0, 25.0}, {0.75, 0.75}), 60.0, false, kHub_m,
                     kRadius_m};
      return fly(p, lidar, 40.0);
    };
    const auto out = estimate(model);
    EXPECT_NEAR(out.rews_mps, 11.0, 1e-6);
    EXPECT_NEAR(out.mean_speed_mps, 11.0, 1e-9);
    EXPECT_NEAR(out.lead_s, 50.0 / 11.0, 0.3);
    const bool one = model == InductionModel::kOneDimensional;
    const auto other =
        estimate(one ? InductionModel::kVortexCylinder : InductionModel::kOneDimensional);
    EXPECT_GT(std::abs(other.rews_mps - 11.0), 1e-4);
    EXPECT_LT(estimate(InductionModel::kNone).rews_mps, 10.7);
  }
}

// A thrust that falls with the wind: the free wind is found all the same, through its slow mean.
TEST(LdpSimulated, InductionOfTheOperatingPoint) {
  UniformWindParams steady;
  steady.history = SteadySpeed{14.0};
  const UniformWind free(steady);
  const LookupTable thrust({11.0, 13.0, 15.0, 18.0}, {0.75, 0.5, 0.34, 0.2});
  InductionParams zone;
  zone.model = InductionModel::kVortexCylinder;
  zone.thrust_coefficient = thrust.at(14.0);
  InducedWind wind(free, zone, kRadius_m);
  wind.follow(0.0, {0.0, 0.0, kHub_m}, kStep_s);
  LidarSim lidar(four_beams(), wind, {kHub_m, kStep_s, 310.0});
  LdpParams p = processing(WindModel::U, 60.0);
  p.induction = {InductionModel::kVortexCylinder, thrust, 60.0, false, kHub_m, kRadius_m};
  EXPECT_NEAR(fly(p, lidar, 300.0).rews_mps, 14.0, 1e-3);
}

// Travel through the slowed wind against a fine sum, and against none: with a = 1/3 wind from
// 100 m needs 20 % more.
TEST(InductionCorrection, SlowsTravel) {
  const double a = 1.0 / 3.0;
  InductionCorrectionParams p{InductionModel::kOneDimensional,
                              LookupTable({5.0, 20.0}, {8.0 / 9.0, 8.0 / 9.0}),
                              60.0,
                              true,
                              kHub_m,
                              kRadius_m};
  const InductionCorrection slow(p);
  auto state = slow.initial_state(1);
  slow.add(10.0, 1.0, state);
  EXPECT_NEAR(state.factor, a, 1e-15);
  for (const double ahead_m : {1.0, 50.0, 100.0, 170.0, 300.0}) {
    double sum_m = 0.0;
    for (int i = 0; i < 100000; ++i) {
      const double s_m = (i + 0.5) * ahead_m / 100000;
      sum_m += ahead_m / 100000 / (1.0 - a * (1.0 - s_m / std::hypot(s_m, kRadius_m)));
    }
    EXPECT_NEAR(slow.travel_m(ahead_m, state), sum_m, 2e-4 * ahead_m);
  }
  EXPECT_NEAR(slow.travel_m(100.0, state), 119.0, 3.0);
  p.slows_travel = false;
  EXPECT_EQ(InductionCorrection(p).travel_m(100.0, state), 100.0);
}

/// Kaimal turbulence of class A at 16 m/s with the standard's shear, turned.
TurnedWind turbulent(double yaw_rad) {
  KaimalFieldParams k;
  k.model = iec_kaimal(2.82, kHub_m);
  k.mean_speed_mps = 16.0;
  k.shear_exponent = 0.2;
  k.width_m = k.height_m = 170.0;
  k.ny = k.nz = 18;
  k.dt_s = 0.2;
  k.duration_s = 660.0;
  k.lateral_coherence = LateralCoherence::kSameAsU;
  auto field = std::make_unique<GriddedWind>(make_kaimal_field(k));
  return {std::move(field), kHub_m, {yaw_rad, 0.0, 180.0}};
}

// Ten minutes of turbulence with a yaw error: direction and shear come out, the REWS is the
// component along the rotor axis. Bands: bias and three standard deviations over ten seeds
// (docs/reconstruction.md).
TEST(LdpSimulated, YawErrorAndShearInTurbulence) {
  const double yaw_rad = rad_from_deg(10.0);
  const TurnedWind wind = turbulent(-yaw_rad);  // turned to the left: positive in LDP
  const LidarSetting setting{kHub_m, kStep_s, 620.0};
  LidarSim first(four_beams(30.0), wind, setting), second(four_beams(30.0), wind, setting);
  const auto yaw = fly(processing(WindModel::UV, 590.0), first, 600.0);
  const auto shear = fly(processing(WindModel::UShear, 590.0), second, 600.0);
  EXPECT_NEAR(deg_from_rad(yaw.wind.yaw_error_rad), 10.0, 3.0);
  EXPECT_NEAR(yaw.mean_speed_mps, 16.0 * std::cos(yaw_rad), 0.9);
  EXPECT_NEAR(shear.wind.du_dz_per_s, 0.2 * 16.0 * std::cos(yaw_rad) / kHub_m, 0.01);
  EXPECT_EQ(yaw.wind.reason, WindReason::Complete);
}

// The test against outliers leaves the gusts of such turbulence alone (0.5 % over three seeds).
TEST(LdpSimulated, TurbulenceIsNoSpike) {
  const TurnedWind wind = turbulent(0.0);
  LidarSim lidar(four_beams(30.0), wind, {kHub_m, kStep_s, 320.0});
  LdpParams p = processing(WindModel::U, 60.0);
  p.spikes.limit = 4.0;
  p.availability_window_s = 1000.0;
  const auto out = fly(p, lidar, 300.0);
  EXPECT_GT(out.availability, 0.985);
  EXPECT_TRUE(out.valid);
}

}  // namespace
}  // namespace lac
