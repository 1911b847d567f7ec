// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_sim.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/lidar/function_wind.hpp"
#include "support/error_text.hpp"
#include "support/no_alloc_guard.hpp"

namespace lac::sim {
namespace {

using test::FunctionWind;
using ::testing::HasSubstr;

Vec3 oblique(const Vec3&, double) {
  return {12.0, 3.0, -1.5};
}

/// GUO table 3: beams +-14.4 / +-14 deg, gates along the axis, 30 m.
LidarParams four_beams() {
  LidarParams p;
  const double a = rad_from_deg(14.4);
  const double e = rad_from_deg(14.0);
  p.scan.beams = {{a, e, 0.0, {}}, {a, -e, 0.0, {}}, {-a, -e, 0.0, {}}, {-a, e, 0.0, {}}};
  p.gates_m = {50.0, 110.0, 170.0};
  p.gates_along_beam = false;
  return p;
}

LidarParams one_beam(double range_m) {
  LidarParams p;
  p.scan.beams = {{}};
  p.gates_m = {range_m};
  return p;
}

const LidarSetting kSetting{90.0, 0.0125, 60.0};

LidarMeasurement first_measurement(LidarSim& lidar, const TurbineState& turbine = {}) {
  LidarMeasurement m;
  for (int n = 0; n < 1000; ++n) {
    if (lidar.step(n, turbine, m)) return m;
  }
  ADD_FAILURE() << "no measurement";
  return m;
}

// Uniform oblique wind: every beam and gate sees -n . U, with n built by hand: up-wind is -x, a
// positive azimuth (left of the viewing axis) looks to -y.
TEST(LidarSimTest, ProjectsUniformWind) {
  const FunctionWind wind(oblique);
  LidarSim lidar(four_beams(), wind, kSetting);
  const double ca = std::cos(rad_from_deg(14.4)), sa = std::sin(rad_from_deg(14.4));
  const double ce = std::cos(rad_from_deg(14.0)), se = std::sin(rad_from_deg(14.0));
  const double left[] = {1, 1, -1, -1};
  const double up[] = {1, -1, -1, 1};
  LidarMeasurement m;
  int seen = 0;
  for (int n = 0; n < 100; ++n) {
    if (!lidar.step(n, {}, m)) continue;
    const int b = seen++ % 4;
    EXPECT_EQ(m.beam_id, b);
    const double expected = 12.0 * ce * ca + 3.0 * ce * sa * left[b] + 1.5 * se * up[b];
    for (int g = 0; g < 3; ++g) {
      EXPECT_NEAR(m.gates[static_cast<std::size_t>(g)].speed_mps, expected, 1e-12);
      EXPECT_TRUE(m.gates[static_cast<std::size_t>(g)].valid);
    }
  }
  EXPECT_EQ(seen, 4);
}

// Distances along the axis become ranges of 50 m / (cos(azimuth) cos(elevation)).
TEST(LidarSimTest, GatesAlongTheAxis) {
  const FunctionWind wind(oblique);
  LidarSim lidar(four_beams(), wind, kSetting);
  const LidarMeasurement m = first_measurement(lidar);
  const double slant = 1.0 / (std::cos(rad_from_deg(14.4)) * std::cos(rad_from_deg(14.0)));
  EXPECT_EQ(m.gate_count, 3);
  EXPECT_NEAR(m.gates[0].range_m, 50.0 * slant, 1e-12);
  EXPECT_NEAR(m.gates[2].range_m, 170.0 * slant, 1e-12);
}

// A tilted lidar says so, and direction and attitude it reports reproduce its speed: looking
// down by 5 deg it sees 12 cos 5 - 1.5 sin 5 (w = -1.5 blows along the beam, away from it).
TEST(LidarSimTest, Tilt) {
  const FunctionWind wind(oblique);
  LidarParams p = one_beam(100.0);
  p.mounting.tilt_rad = rad_from_deg(5.0);
  LidarSim lidar(p, wind, kSetting);
  const LidarMeasurement m = first_measurement(lidar);
  EXPECT_NEAR(m.gates[0].speed_mps,
              12.0 * std::cos(rad_from_deg(5.0)) - 1.5 * std::sin(rad_from_deg(5.0)), 1e-12);
  EXPECT_NEAR(m.gates[0].speed_mps, -dot(m.beam_dir_I(), Vec3{12.0, 3.0, -1.5}), 1e-12);
}

// The tower top moving up-wind at 0.5 m/s adds 0.5 m/s times the axial part of the beam; position
// and velocity are reported.
TEST(LidarSimTest, MovingNacelle) {
  const FunctionWind wind(oblique);
  LidarParams p = four_beams();
  p.mounting.offset_m = {-1.0, 0.5, 3.0};
  LidarSim still(p, wind, kSetting);
  LidarSim moving(p, wind, kSetting);
  const LidarMeasurement a = first_measurement(still);
  const LidarMeasurement b = first_measurement(moving, {0.25, -0.5});
  EXPECT_NEAR(b.gates[1].speed_mps - a.gates[1].speed_mps,
              0.5 * std::cos(rad_from_deg(14.4)) * std::cos(rad_from_deg(14.0)), 1e-12);
  EXPECT_EQ(b.position_I_m, (Vec3{-0.75, 0.5, 93.0}));
  EXPECT_EQ(b.velocity_I_mps, (Vec3{-0.5, 0.0, 0.0}));
  EXPECT_DOUBLE_EQ(b.yaw_rad, kPi);
}

constexpr double kWaveNumber_radpm = 0.06;

// A Gaussian volume lets a wave exp(i k x) pass with exp(-(k sigma)^2/2). Tolerance: the
// quadrature ends at three standard deviations, which lets 0.6 % more pass here.
TEST(LidarSimTest, GaussianVolume) {
  const auto gain = [](double fwhm_m, double range_m, FunctionWind::Function f) {
    const FunctionWind wind(f);
    LidarParams p = one_beam(50.0);
    p.gates_m.push_back(range_m);
    p.weighting.fwhm_m = fwhm_m;
    LidarSim lidar(p, wind, kSetting);
    return first_measurement(lidar).gates[1].speed_mps;
  };
  const FunctionWind::Function cosine = [](const Vec3& x, double) {
    return Vec3{std::cos(kWaveNumber_radpm * x.x), 0.0, 0.0};
  };
  const FunctionWind::Function sine = [](const Vec3& x, double) {
    return Vec3{std::sin(kWaveNumber_radpm * x.x), 0.0, 0.0};
  };
  const double sigma_m = 30.0 / 2.354820045;
  const double expected = std::exp(-0.5 * std::pow(kWaveNumber_radpm * sigma_m, 2));
  for (const double range_m : {53.0, 100.0, 161.8, 300.0}) {
    EXPECT_NEAR(std::abs(std::complex(gain(30.0, range_m, cosine), gain(30.0, range_m, sine))),
                expected, 5e-3);
  }
  EXPECT_NEAR(std::abs(std::complex(gain(0.0, 100.0, cosine), gain(0.0, 100.0, sine))), 1.0, 1e-12);
}

// Gates that share the points of a beam each see their own volume: the mean of a straight line
// of wind over x is the wind at the gate centre, to the asymmetry of the last point (0.2 m).
TEST(LidarSimTest, EveryGateHasItsOwnVolume) {
  const FunctionWind wind([](const Vec3& x, double) { return Vec3{-x.x, 0.0, 0.0}; });
  LidarParams p = one_beam(50.0);
  p.gates_m = {50.0, 63.3, 76.7, 90.0, 170.0, 400.0};
  LidarSim lidar(p, wind, kSetting);
  const LidarMeasurement m = first_measurement(lidar);
  for (std::size_t g = 0; g < p.gates_m.size(); ++g) {
    EXPECT_NEAR(m.gates[g].speed_mps, p.gates_m[g], 0.2) << g;
    EXPECT_EQ(m.gates[g].range_m, p.gates_m[g]);
  }
}

// One beam after the other, each in the first control step at or after its time, flag up once.
TEST(LidarSimTest, ScanSchedule) {
  const FunctionWind wind(oblique);
  LidarSim lidar(four_beams(), wind, kSetting);
  LidarMeasurement m;
  for (int n = 0; n <= 400; ++n) {
    const bool is_new = lidar.step(n, {}, m);
    EXPECT_EQ(is_new, n > 0 && n % 20 == 0) << n;
    if (!is_new) continue;
    EXPECT_EQ(m.beam_id, (n / 20 - 1) % 4);
    EXPECT_DOUBLE_EQ(m.time_s, 0.0125 * n);
  }
}

// Beam time 0.03 s, step 0.0125 s: completed at 0.03, 0.06, 0.09 ... handed over at 0.0375,
// 0.0625, 0.1 ...; none is lost and the wind is that of the time of completion.
TEST(LidarSimTest, BeamTimeNoMultipleOfTheStep) {
  const FunctionWind wind([](const Vec3&, double t) { return Vec3{t, 0.0, 0.0}; });
  LidarParams p = one_beam(50.0);
  p.scan.beam_time_s = 0.03;
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  std::vector<int> steps;
  for (int n = 0; n <= 240; ++n) {
    if (!lidar.step(n, {}, m)) continue;
    steps.push_back(n);
    EXPECT_NEAR(m.time_s, 0.03 * static_cast<double>(steps.size()), 1e-12);
    EXPECT_NEAR(m.gates[0].speed_mps, m.time_s, 1e-12);
    EXPECT_GE(0.0125 * n, m.time_s - 1e-9);
    EXPECT_LT(0.0125 * (n - 1), m.time_s - 1e-9);
  }
  EXPECT_EQ(steps.size(), 100U);
}

// Two beams in one control step cannot be handed over.
TEST(LidarSimTest, BeamTimeBelowTheStep) {
  const FunctionWind wind(oblique);
  LidarParams p = one_beam(50.0);
  p.scan.beam_time_s = 0.01;
  try {
    LidarSim lidar(p, wind, kSetting);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("beam_time_s = 0.01 is shorter than the control step"));
  }
}

std::string extent_error(const LidarParams& p, const WindExtent& extent) {
  const FunctionWind wind(oblique, extent);
  try {
    LidarSim lidar(p, wind, kSetting);
  } catch (const Error& e) {
    return e.what();
  }
  return "none";
}

// The far end of the range weighting of a gate at x = 170 m, 3 sigma further along the beam.
TEST(LidarSimTest, BeamLeavesTheField) {
  LidarParams p = four_beams();
  p.gates_m = {170.0};
  const double ca = std::cos(rad_from_deg(14.4)), sa = std::sin(rad_from_deg(14.4));
  const double ce = std::cos(rad_from_deg(14.0)), se = std::sin(rad_from_deg(14.0));
  const double reach_m = 170.0 / (ca * ce) + 3.0 * 30.0 / 2.354820045;
  const double y_m = reach_m * ce * sa;
  const double z_m = reach_m * se;
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(extent_error(p, {-y_m, y_m, 90 - z_m, 90 + z_m, -inf, inf}), "none");
  EXPECT_THAT(extent_error(p, {-y_m + 1.0, y_m, 90 - z_m, 90 + z_m, -inf, inf}),
              HasSubstr("beam 1, gate 1 (with its range weighting) leaves the wind field by 1 m "
                        "sideways"));
  EXPECT_THAT(extent_error(p, {-y_m, y_m, 90 - z_m + 2.0, 90 + z_m, -inf, inf}),
              HasSubstr("beam 2, gate 1 (with its range weighting) leaves the wind field by 2 m in "
                        "height"));
  EXPECT_THAT(extent_error(four_beams(), {-y_m, y_m, 90 - z_m + 5.0, 90 + z_m, -inf, inf}),
              HasSubstr("beam 2, gate 3"));
}

// The field must last until the wind seen at the end of the run reaches the rotor: 100 m and
// three standard deviations, 3 m of tower travel, at 10 m/s.
TEST(LidarSimTest, FieldEndsTooEarly) {
  WindExtent extent;
  extent.t_max_s = 60.0 + (100.0 + 3 * 30.0 / 2.354820045 + 3.0) / 10.0 + 1e-6;
  EXPECT_EQ(extent_error(one_beam(100.0), extent), "none");
  extent.t_max_s -= 0.5;
  EXPECT_THAT(extent_error(one_beam(100.0), extent), HasSubstr("s at the end"));
}

// Averaged over the beam time: of a wind that grows with time (u = t) the middle of the quarter of
// a second, of a wave with that period nothing, and of the half wave of twice the period
// 1/(8 sin(pi/16)) with eight samples (2/pi in the limit).
TEST(LidarSimTest, MeanOverTheBeamTime) {
  const FunctionWind ramp([](const Vec3&, double t) { return Vec3{t, 0.0, 0.0}; });
  const FunctionWind wave([](const Vec3&, double t) {
    return Vec3{std::cos(2.0 * kPi * t / 0.25), 0.0, 0.0};
  });
  const FunctionWind slow([](const Vec3&, double t) {
    return Vec3{std::sin(2.0 * kPi * t / 0.5), 0.0, 0.0};
  });
  LidarParams p = one_beam(50.0);
  p.scan.samples_per_beam = 8;
  LidarSim on_ramp(p, ramp, kSetting), on_wave(p, wave, kSetting), on_slow(p, slow, kSetting);
  EXPECT_NEAR(first_measurement(on_ramp).gates[0].speed_mps, 0.125, 1e-12);
  EXPECT_NEAR(first_measurement(on_wave).gates[0].speed_mps, 0.0, 1e-12);
  EXPECT_NEAR(first_measurement(on_slow).gates[0].speed_mps, 1.0 / (8.0 * std::sin(kPi / 16.0)),
              1e-12);
  EXPECT_DOUBLE_EQ(first_measurement(on_ramp).time_s, 0.5);
}

// Pauses between beams and after the scan: ends at 0.25, 0.6, 1.15, 1.5, ... s, each handed over in
// the first step at or after it.
TEST(LidarSimTest, Pauses) {
  const FunctionWind wind(oblique);
  LidarParams p = one_beam(50.0);
  p.scan.beams = {{}, {}};
  p.scan.beam_pause_s = 0.1;
  p.scan.scan_pause_s = 0.3;
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  std::vector<int> steps;
  for (int n = 0; n <= 200; ++n) {
    if (lidar.step(n, {}, m)) steps.push_back(n);
  }
  EXPECT_EQ(steps, (std::vector<int>{20, 48, 92, 120, 164, 192}));
}

// Three beams taken at once: three consecutive steps, one time, one wind, each its own beam.
TEST(LidarSimTest, BeamsTakenAtOnce) {
  const FunctionWind wind([](const Vec3&, double t) { return Vec3{t, 0.0, 0.0}; });
  LidarParams p = one_beam(50.0);
  p.scan.beams = {{}, {}, {}};
  p.scan.beam_time_s = 0.5;
  p.scan.simultaneous = true;
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  int seen = 0;
  for (int n = 0; n <= 100; ++n) {
    const bool is_new = lidar.step(n, {}, m);
    EXPECT_EQ(is_new, n >= 40 && n % 40 < 3) << n;
    if (!is_new) continue;
    EXPECT_EQ(m.beam_id, seen++ % 3);
    EXPECT_EQ(m.time_s, n < 80 ? 0.5 : 1.0);
    EXPECT_NEAR(m.gates[0].speed_mps, m.time_s, 1e-12);
  }
  EXPECT_EQ(seen, 6);
}

// They must all be handed over before the next ones are there: 41 beams in half a second of steps
// of 0.0125 s do not fit, 40 do and none is lost.
TEST(LidarSimTest, TooManyBeamsAtOnce) {
  const FunctionWind wind(oblique);
  LidarParams p = one_beam(50.0);
  p.scan.beams.assign(41, LidarBeam{});
  p.scan.beam_time_s = 0.5;
  p.scan.simultaneous = true;
  EXPECT_THAT(test::error_text([&] { LidarSim(p, wind, kSetting); }),
              HasSubstr("41 beams taken at once need as many control steps, 0.5125 s, to be handed "
                        "over, and the scan takes 0.5 s"));
  p.scan.beams.pop_back();
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  for (int n = 40; n <= 4800; ++n) {
    ASSERT_TRUE(lidar.step(n, {}, m)) << n;
    ASSERT_EQ(m.beam_id, n % 40) << n;
    ASSERT_EQ(m.time_s, 0.5 * (n / 40)) << n;
  }
}

// The lidar block of the swap array carries 50 gates.
TEST(LidarSimTest, NumberOfGates) {
  const FunctionWind wind(oblique);
  LidarParams p = one_beam(50.0);
  p.gates_m.clear();
  EXPECT_THAT(test::error_text([&] { LidarSim(p, wind, kSetting); }),
              HasSubstr("lidar: beam 1 has 0 gates, expected 1 to 50"));
  for (int g = 0; g < 50; ++g) p.gates_m.push_back(50.0 + g);
  EXPECT_EQ(test::error_text([&] { LidarSim(p, wind, kSetting); }), "no error");
  p.gates_m.push_back(100.0);
  EXPECT_THAT(test::error_text([&] { LidarSim(p, wind, kSetting); }),
              HasSubstr("lidar: beam 1 has 51 gates, expected 1 to 50, as the lidar block"));
}

// A beam with gates of its own.
TEST(LidarSimTest, OwnGates) {
  const FunctionWind wind(oblique);
  LidarParams p = one_beam(50.0);
  p.scan.beams = {{}, {0.0, 0.0, 0.5, {80.0, 120.0}}};
  LidarSim lidar(p, wind, kSetting);
  EXPECT_EQ(first_measurement(lidar).gate_count, 1);
  LidarMeasurement m;
  for (int n = 21; n < 60; ++n) EXPECT_FALSE(lidar.step(n, {}, m)) << n;
  ASSERT_TRUE(lidar.step(60, {}, m));
  EXPECT_EQ(m.beam_id, 1);
  EXPECT_EQ(m.gate_count, 2);
  EXPECT_EQ(m.gates[1].range_m, 120.0);
}

// Nothing is allocated in a step, with all that a lidar can have.
TEST(LidarSimTest, StepDoesNotAllocate) {
  const FunctionWind wind(oblique);
  LidarParams p = four_beams();
  p.scan.samples_per_beam = 3;
  p.scan.simultaneous = true;
  p.mounting.place = MountingPlace::kSpinner;
  p.platform.freedoms[kPlatformPitch].harmonics = {{0.03, 10.0, 0.0}};
  LidarSim lidar(p, wind, kSetting);
  LidarMeasurement m;
  int seen = 0;
  const test::NoAllocGuard guard;
  for (int n = 0; n < 400; ++n) seen += lidar.step(n, {}, m) ? 1 : 0;
  EXPECT_EQ(guard.allocations(), 0U);
  EXPECT_GT(seen, 70);
}

// A lidar that would deliver nothing before the run ends.
TEST(LidarSimTest, NeverDelivers) {
  const FunctionWind wind([](const Vec3&, double) { return Vec3{10.0, 0.0, 0.0}; });
  LidarParams p;
  p.scan.beams = {{}};
  p.gates_m = {100.0};
  p.scan.beam_time_s = 1e9;
  const LidarSetting setting{90.0, 0.0125, 60.0};
  EXPECT_EQ(
      test::error_text([&] { LidarSim(p, wind, setting); }),
      "lidar: the first measurement is complete after 1e+09 s, the run ends at 60 s; expected "
      "a shorter beam_time_s or a longer run");
  p.scan.beam_time_s = 60.0;
  EXPECT_EQ(test::error_text([&] { LidarSim(p, wind, setting); }), "no error");
}

}  // namespace
}  // namespace lac::sim
