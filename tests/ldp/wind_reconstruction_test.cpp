// SPDX-License-Identifier: Apache-2.0
#include "ldp/wind_reconstruction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "ldp/symmetric_eigen.hpp"
#include "support/error_text.hpp"

namespace lac {
namespace {

using testing::HasSubstr;

constexpr double kRadius_m = 63.0;

WindModelParams with(WindModel model) {
  WindModelParams p;
  p.model = model;
  p.hub_height_m = 90.0;
  p.rotor_radius_m = kRadius_m;
  return p;
}

/// A linear field, and what beams from (x, y, z) = lidar_m, from the hub, see of it.
struct Scene {
  double u = 12.0, v = 0.0, w = 0.0, uy = 0.0, uz = 0.0, ux = 0.0;
  Vec3 lidar_m;
  double induction = 1.0;

  WindReconstruction::Sample sample(const Vec3& n, double range_m) const {
    WindReconstruction::Sample s;
    s.beam_dir_I = n;
    s.from_hub_I_m = lidar_m + range_m * n;
    s.induction = induction;
    const Vec3& p = s.from_hub_I_m;
    const double there = induction * (u + uy * p.y + uz * p.z + ux * (p.x + 110.0));
    s.los_mps = -(n.x * there + n.y * v + n.z * w);
    return s;
  }
};

/// Level angle to -y, elevation up, seen up-wind.
Vec3 beam(double azimuth_deg, double elevation_deg) {
  const double a = rad_from_deg(azimuth_deg), e = rad_from_deg(elevation_deg);
  return {-std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a), std::sin(e)};
}

const std::vector<Vec3> kFour{beam(14.4, 14.0), beam(14.4, -14.0), beam(-14.4, -14.0),
                              beam(-14.4, 14.0)};
const std::vector<double> kTenGates{50, 63.3, 76.7, 90, 103.3, 116.7, 130, 143.3, 156.7, 170};

WindReconstruction::State scanned(const WindModelParams& params, const Scene& scene,
                                  const std::vector<Vec3>& beams, const std::vector<double>& gates,
                                  const std::function<double(std::size_t)>& weight = {}) {
  const WindReconstruction r(params);
  WindReconstruction::State state = r.initial_state();
  for (int k = 0; k < 3; ++k) {
    for (const Vec3& n : beams) {
      WindReconstruction::Sums sums;
      for (std::size_t g = 0; g < gates.size(); ++g) {
        auto s = scene.sample(n, gates[g] / -n.x);
        if (weight) s.weight = weight(g);
        r.add(s, sums);
      }
      r.add(sums, {}, state);
    }
  }
  r.solve(state);
  return state;
}

WindReconstruction::Estimate seen(WindModel model, const Scene& scene,
                                  const std::vector<Vec3>& beams = kFour,
                                  const std::vector<double>& gates = kTenGates) {
  return scanned(with(model), scene, beams, gates).estimate;
}

// Jacobi's eigenvalues of a matrix with known ones: V diag V^T gives it back.
TEST(SymmetricEigen, GivesTheMatrixBack) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    SymmetricEigen<6>::Matrix a{};
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t j = 0; j <= i; ++j) a[i][j] = a[j][i] = normal(random);
    }
    const auto e = SymmetricEigen<6>::of(a, 5);
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t j = 0; j < 5; ++j) {
        double sum = 0.0, unit = 0.0;
        for (std::size_t k = 0; k < 5; ++k) {
          sum += e.vectors[i][k] * e.values[k] * e.vectors[j][k];
          unit += e.vectors[i][k] * e.vectors[j][k];
        }
        EXPECT_NEAR(sum, a[i][j], 1e-13);
        EXPECT_NEAR(unit, i == j ? 1.0 : 0.0, 1e-14);
      }
    }
  }
}

void expect_value(double value, bool asked, double expected, double error) {
  if (asked) {
    EXPECT_NEAR(value, expected, error);
  } else {
    EXPECT_TRUE(std::isnan(value));
  }
}

// Fields that the model describes come back to rounding, also from a lidar off the hub, with
// weights of the gates, under induction, and with a change along x that nobody asked for (u then
// is that of the mean place). What the model does not have is not a number.
TEST(WindReconstruction, LinearFieldsAreExact) {
  const auto weight = [](std::size_t g) { return 1.0 + 0.3 * static_cast<double>(g); };
  for (const WindModel model : {WindModel::UShear, WindModel::UV, WindModel::UVW, WindModel::All}) {
    for (const double along : {0.0, 0.004}) {
      const bool all = model == WindModel::All;
      const bool shear = all || model == WindModel::UShear, v = all || !shear;
      const bool w = all || model == WindModel::UVW;
      Scene s;
      s.lidar_m = {3.0, 0.4, 2.2};
      s.induction = 0.93;
      s.ux = along;
      if (v) s.v = 1.3;
      if (w) s.w = -0.6;
      if (shear) s.uy = 0.011;
      if (shear) s.uz = 0.027;
      const auto e = scanned(with(model), s, kFour, kTenGates, weight).estimate;
      EXPECT_EQ(e.reason, WindReason::Complete) << static_cast<int>(model);
      EXPECT_NEAR(e.u_mps, 12.0, along == 0.0 ? 1e-12 : 0.2);
      expect_value(e.v_mps, v, 1.3, 1e-12);
      expect_value(e.w_mps, w, -0.6, 1e-12);
      expect_value(e.du_dy_per_s, shear, 0.011, 1e-13);
      expect_value(e.du_dz_per_s, shear, 0.027, 1e-13);
    }
  }
}

// DBS: four beams at a half-angle, one range; the pseudo-inverse of methods section 8 by hand,
// (N - S)/(2 sin), (W - E)/(2 sin), (N + W + S + E)/(4 cos), for any four speeds.
TEST(WindReconstruction, PseudoInverseOfDbs) {
  const double a = rad_from_deg(28.0), s = std::sin(a), c = std::cos(a);
  const std::vector<Vec3> beams{{s, 0, c}, {0, s, c}, {-s, 0, c}, {0, -s, c}};
  const std::vector<double> los{-3.1, 0.4, 4.9, 1.0};  // -n . U
  const WindReconstruction r(with(WindModel::UVW));
  auto state = r.initial_state();
  for (std::size_t b = 0; b < 4; ++b) {
    WindReconstruction::Sums sums;
    WindReconstruction::Sample sample;
    sample.beam_dir_I = beams[b];
    sample.los_mps = los[b];
    r.add(sample, sums);
    r.add(sums, {}, state);
  }
  r.solve(state);
  EXPECT_NEAR(state.estimate.u_mps, -(los[0] - los[2]) / (2.0 * s), 1e-13);
  EXPECT_NEAR(state.estimate.v_mps, -(los[1] - los[3]) / (2.0 * s), 1e-13);
  EXPECT_NEAR(state.estimate.w_mps, -(los[0] + los[1] + los[2] + los[3]) / (4.0 * c), 1e-13);
}

// A flow inclined by a_v with a shear d_v across it is not what DBS assumes: u is too small by
// d_v z sin^2 a_v (methods section 8).
TEST(WindReconstruction, BiasOfDbsInInclinedShear) {
  const double a = rad_from_deg(28.0), s = std::sin(a), c = std::cos(a);
  const double incline = rad_from_deg(8.0), shear = 0.03, z_m = 120.0, at_lidar_mps = 9.0;
  const Vec3 along{std::cos(incline), 0.0, std::sin(incline)};
  const WindReconstruction r(with(WindModel::UVW));
  auto state = r.initial_state();
  for (const Vec3& n : {Vec3{s, 0, c}, Vec3{0, s, c}, Vec3{-s, 0, c}, Vec3{0, -s, c}}) {
    const Vec3 p = (z_m / c) * n;
    const double across_m = p.z * std::cos(incline) - p.x * std::sin(incline);
    WindReconstruction::Sample sample;
    sample.beam_dir_I = n;
    sample.los_mps = -(at_lidar_mps + shear * across_m) * dot(n, along);
    WindReconstruction::Sums sums;
    r.add(sample, sums);
    r.add(sums, {}, state);
  }
  r.solve(state);
  const double true_mps = (at_lidar_mps + shear * z_m * std::cos(incline)) * std::cos(incline);
  EXPECT_NEAR(true_mps - state.estimate.u_mps, shear * z_m * std::sin(incline) * std::sin(incline),
              1e-12);
}

// The condition number against closed forms: u and v from +-30 deg have columns of length cos and
// sin, 1.732; with w from 14.4/14 deg 1/tan of the smaller angle.
TEST(WindReconstruction, ConditionInClosedForm) {
  EXPECT_NEAR(seen(WindModel::UV, {}, {beam(30, 0), beam(-30, 0)}, {37.0}).condition,
              1.0 / std::tan(rad_from_deg(30.0)), 1e-12);
  const double across = std::cos(rad_from_deg(14.0)) * std::sin(rad_from_deg(14.4));
  const double up = std::sin(rad_from_deg(14.0));
  const double along = std::cos(rad_from_deg(14.0)) * std::cos(rad_from_deg(14.4));
  EXPECT_NEAR(seen(WindModel::UVW, {}, kFour, {100.0}).condition, along / std::min(up, across),
              1e-12);
}

// Two level beams: v, or the horizontal shear, but never the vertical one; u is that of their
// height.
TEST(WindReconstruction, TwoLevelBeams) {
  const std::vector<Vec3> two{beam(30, 0), beam(-30, 0)};
  Scene s;
  s.uy = 0.02;
  s.uz = 0.03;
  s.lidar_m = {0.0, 0.0, 2.0};
  const auto shear = seen(WindModel::UShear, s, two, {37.0});
  EXPECT_EQ(shear.reason, WindReason::Partly);
  EXPECT_NEAR(shear.du_dy_per_s, 0.02, 1e-12);
  EXPECT_TRUE(std::isnan(shear.du_dz_per_s));
  EXPECT_NEAR(shear.u_mps, 12.0 + 0.03 * 2.0, 2e-2);
  EXPECT_TRUE(std::isinf(shear.condition) || shear.condition > 1e6);
  Scene yawed;
  yawed.v = 2.0;
  EXPECT_NEAR(seen(WindModel::UV, yawed, two, {37.0}).v_mps, 2.0, 1e-12);
  EXPECT_EQ(seen(WindModel::UVW, yawed, two, {37.0}).reason, WindReason::Partly);
}

// One oblique beam tells nothing but u, however many gates it has: a change along it may be shear
// or a change along x. So does one that looks straight ahead.
TEST(WindReconstruction, OneBeamIsRefused) {
  for (const Vec3& n : {beam(15, 0), beam(15, 10), beam(0, 0)}) {
    for (const WindModel model :
         {WindModel::UShear, WindModel::UV, WindModel::UVW, WindModel::All}) {
      const auto e = seen(model, {}, {n});
      EXPECT_EQ(e.reason, WindReason::Refused) << static_cast<int>(model);
      EXPECT_TRUE(std::isnan(e.v_mps) && std::isnan(e.du_dy_per_s) && std::isnan(e.du_dz_per_s));
    }
  }
}

// At one distance v and horizontal shear are the same to beams that cross the axis, v = -d du/dy,
// and w and vertical shear likewise: both models are right for their own wind and take the other's
// for it; asked for all, none of the four is told, and u is. Several gates can tell them.
TEST(WindReconstruction, ShearOrLateralWind) {
  Scene yawed;
  yawed.v = 2.0;
  EXPECT_NEAR(seen(WindModel::UShear, yawed, kFour, {100.0}).du_dy_per_s, 2.0 / -100.0, 1e-12);
  Scene sheared;
  sheared.uy = -0.02;
  sheared.uz = 0.03;
  EXPECT_NEAR(seen(WindModel::UVW, sheared, kFour, {100.0}).v_mps, 2.0, 1e-12);
  EXPECT_NEAR(seen(WindModel::UVW, sheared, kFour, {100.0}).w_mps, -3.0, 1e-12);
  const auto all = seen(WindModel::All, sheared, kFour, {100.0});
  EXPECT_EQ(all.reason, WindReason::Refused);
  EXPECT_NEAR(all.u_mps, 12.0, 1e-12);
  const auto gates = seen(WindModel::All, sheared);
  EXPECT_EQ(gates.reason, WindReason::Complete);
  EXPECT_LT(gates.condition, 30.0);
  EXPECT_NEAR(gates.v_mps, 0.0, 1e-12);
}

// The estimate is a mean over the window: half-way through a step of the wind it is half-way, and
// before the first window there is none. Silence withdraws it, long silence forgets it.
TEST(WindReconstruction, IsASlowMean) {
  WindModelParams p = with(WindModel::UV);
  p.window_s = 100.0;
  const WindReconstruction r(p);
  auto state = r.initial_state();
  Scene s;
  double t = 0.0;
  const auto fly = [&](double seconds) {
    for (int k = 0; k < static_cast<int>(seconds * 4.0); ++k, t += 0.25) {
      WindReconstruction::Sums sums;
      r.add(s.sample(kFour[static_cast<std::size_t>(k % 4)], 100.0), sums);
      r.add(sums, {.time_s = t}, state);
    }
  };
  fly(99.0);
  EXPECT_EQ(state.estimate.reason, WindReason::Settling);
  fly(2.0);
  EXPECT_EQ(state.estimate.reason, WindReason::Complete);
  s.v = 2.0;
  fly(100.0 * std::log(2.0));
  EXPECT_NEAR(state.estimate.v_mps, 1.0, 0.03);
  EXPECT_NEAR(state.estimate.yaw_error_rad, std::atan2(state.estimate.v_mps, state.estimate.u_mps),
              1e-15);
  r.watch(t + 9.0, 1.0, state);
  EXPECT_EQ(state.estimate.reason, WindReason::Complete);
  r.watch(t + 11.0, 1.0, state);
  EXPECT_EQ(state.estimate.reason, WindReason::Stale);
  EXPECT_TRUE(std::isnan(state.estimate.v_mps));
  t += 200.0;
  fly(1.0);
  EXPECT_EQ(state.estimate.reason, WindReason::Settling);
}

// No weight, weights of zero, a sample that is not a number: nothing is made up.
TEST(WindReconstruction, NothingFromNothing) {
  const WindReconstruction r(with(WindModel::UV));
  auto state = r.initial_state();
  r.add(WindReconstruction::Sums{}, {}, state);
  EXPECT_EQ(state.elapsed_s, 0.0);
  r.solve(state);
  EXPECT_EQ(state.estimate.reason, WindReason::Refused);
  EXPECT_TRUE(std::isnan(state.estimate.u_mps));
}

std::string refusal(const std::string& rows, bool sees_across = true) {
  return test::error_text([&] {
    InputFile in = InputFile::parse(rows, "ldp.IN");
    WindModelParams::read(in, sees_across);
    in.finish();
  });
}

// Keys: none needed by default, two with a model, and none of a model that is not used.
TEST(WindModelParams, Keys) {
  const std::string good = "u_v ! WindModel\n90 ! HubHeight\n63 ! RotorRadius\n";
  EXPECT_EQ(refusal(""), "no error");
  EXPECT_EQ(refusal(good + "1 2 ! GateWeights\naverage ! WhenRefused\n"), "no error");
  EXPECT_THAT(refusal("u_v ! WindModel\n"), HasSubstr("HubHeight"));
  EXPECT_THAT(refusal("90 ! ReconstructionWindow\n"), HasSubstr("ReconstructionWindow"));
  EXPECT_THAT(refusal(good + "0 0 ! GateWeights\n"), HasSubstr("not all of them 0"));
  EXPECT_THAT(refusal(good, false), HasSubstr("openfast"));
}

}  // namespace
}  // namespace lac
