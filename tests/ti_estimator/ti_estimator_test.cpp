// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/ti_estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <random>

#include "support/no_alloc_guard.hpp"

namespace lac {
namespace {

constexpr double kTimeStep_s = 0.0125;
constexpr int kStepsPerBeam = 20;  // 4 beams in 1 s
constexpr double kSpeed_mps = 16.0;
constexpr double kAmplitude_mps = 3.0;

TiEstimatorParams params() {
  TiEstimatorParams p;
  p.averaging_time_s = p.correction.averaging_time_s = 60.0;
  p.number_of_gates = 3;
  for (const int beam : {0, 1, 2, 3}) {
    p.beam_dir_L.push_back(beam_direction(rad_from_deg(beam < 2 ? 15.0 : -15.0),
                                          rad_from_deg(beam % 3 == 0 ? 12.5 : -12.5)));
  }
  return p;
}

/// Uniform wind with a sine of 12 s: whole periods in T, and whole samples in a period.
Vec3 sine_wind(double time_s) {
  return {kSpeed_mps + kAmplitude_mps * std::sin(2.0 * kPi * time_s / 12.0), 0.0, 0.0};
}

/// Feeds an estimator with a four-beam scan of a wind that is the same everywhere.
class Rig {
 public:
  explicit Rig(const TiEstimatorParams& p)
      : params_(p), estimator(p, kTimeStep_s), state(estimator.initial_state()) {}

  /// One controller step. `tamper` sees every measurement; false: the measurement is lost.
  TiEstimator::Outputs step() {
    TiEstimator::Inputs in;
    in.time_s = steps_ * kTimeStep_s;
    in.yaw_error_rad = yaw_error_rad;
    if (steps_ % kStepsPerBeam == 0) {
      measure(in.time_s, static_cast<int>(steps_ / kStepsPerBeam % 4));
      if (tamper(measurement)) in.measurement = &measurement;
    }
    ++steps_;
    return estimator.step(in, state);
  }
  TiEstimator::Outputs run_until(double time_s) {
    TiEstimator::Outputs out;
    while (steps_ * kTimeStep_s < time_s - 1e-9) out = step();
    return out;
  }

  std::function<Vec3(double)> wind_I_mps = sine_wind;
  std::function<bool(LidarMeasurement&)> tamper = [](LidarMeasurement&) { return true; };
  std::function<void(double, LidarMeasurement&)> move = [](double, LidarMeasurement&) {};
  double yaw_error_rad = 0.0;
  LidarMeasurement measurement;

 private:
  void measure(double time_s, int beam) {
    LidarMeasurement& m = measurement;
    m = {};
    m.time_s = time_s;
    m.beam_id = beam;
    m.beam_dir_L = params_.beam_dir_L[static_cast<std::size_t>(beam)];
    m.gate_count = 3;
    move(time_s, m);
    const double speed = -dot(m.beam_dir_I(), wind_I_mps(time_s) - m.velocity_I_mps);
    for (std::size_t g = 0; g < 3; ++g) m.gates[g] = {60.0 + 50.0 * g, speed, true, -10.0};
  }

  TiEstimatorParams params_;
  long steps_ = 0;

 public:
  TiEstimator estimator;
  TiEstimator::State state;
};

/// TI that the sine must give: c_TI |n_x| times its sample standard deviation over 60 samples.
double expected_intensity(const TiEstimatorParams& p) {
  const Vec3 n = p.beam_dir_L[0];
  const double std_mps = kAmplitude_mps * std::sqrt(0.5 * 60.0 / 59.0);
  return Correction(p.correction).c_ti(n, kSpeed_mps, 0.0) * n.x * std_mps / kSpeed_mps;
}

/// Bit by bit, NaN included.
bool same(const TiEstimator::Outputs& a, const TiEstimator::Outputs& b) {
  return std::memcmp(&a.intensity, &b.intensity, sizeof a.intensity) == 0 &&
         std::memcmp(&a.power_level, &b.power_level, sizeof a.power_level) == 0;
}

// A process of known variance gives its TI, to the accuracy of the table.
TEST(TiEstimator, KnownVariance) {
  Rig rig(params());
  const auto out = rig.run_until(100.0);
  EXPECT_TRUE(out.valid());
  EXPECT_EQ(out.filled_series, 12);
  EXPECT_NEAR(out.mean_speed_mps, kSpeed_mps, 1e-4);
  EXPECT_NEAR(out.intensity / expected_intensity(params()), 1.0, 2e-3);
}

// The exponential window, whose weights ripple a little with the phase of the sine.
TEST(TiEstimator, KnownVarianceInAnExponentialWindow) {
  TiEstimatorParams p = params();
  p.correction.window = Window::Exponential;
  p.correction.low_frequencies = LowFrequencies::Response;
  Rig rig(p);
  const auto out = rig.run_until(400.0);
  const double left = window_response(60.0 / 12.0, Window::Exponential, Detrending::Mean);
  const Vec3 n = p.beam_dir_L[0];
  const double expected = Correction(p.correction).c_ti(n, kSpeed_mps, 0.0) * n.x * kAmplitude_mps *
                          std::sqrt(0.5 * left) / kSpeed_mps;
  EXPECT_EQ(out.filled_series, 12);
  EXPECT_NEAR(out.intensity / expected, 1.0, 0.02);
  rig.tamper = [](LidarMeasurement&) { return false; };
  EXPECT_FALSE(rig.run_until(460.0).valid());  // after ln 2 / 2 of T: half of the weight
}

// Nothing is said before T has passed, although all series hold enough samples long before.
TEST(TiEstimator, SilentUntilTheWindowIsFilled) {
  Rig rig(params());
  TiEstimator::Outputs out = rig.run_until(60.0);
  EXPECT_EQ(out.filled_series, 12);
  EXPECT_FALSE(out.valid());
  EXPECT_TRUE(std::isnan(out.intensity));
  EXPECT_EQ(out.power_level, 1.0);
  EXPECT_FALSE(out.power_level_valid);
  out = rig.step();
  EXPECT_TRUE(out.valid());
  EXPECT_TRUE(out.power_level_valid);
  EXPECT_NEAR(out.power_level, 1.0, PowerLevelParams{}.rate_1ps * kTimeStep_s * 1.001);
}

// A swaying, nodding and turning nacelle in steady wind is no turbulence (methods section 0):
// mean wind exact, no standard deviation beyond the storage.
TEST(TiEstimator, OwnMotionIsTakenOut) {
  TiEstimatorParams p = params();
  Rig rig(p);
  rig.wind_I_mps = [](double) { return Vec3{kSpeed_mps, 0.0, 0.0}; };
  rig.move = [](double t, LidarMeasurement& m) {
    m.roll_rad = 0.02 * std::sin(0.9 * t);
    m.pitch_rad = 0.03 * std::sin(1.3 * t);
    m.yaw_rad = kPi + 0.15 * std::sin(0.05 * t);
    m.velocity_I_mps = {1.5 * std::sin(1.9 * t), 0.7 * std::cos(1.1 * t), 0.2};
  };
  EXPECT_LT(rig.run_until(90.0).intensity, 1e-5);
  EXPECT_NEAR(rig.run_until(91.0).mean_speed_mps, kSpeed_mps, 1e-5);

  p.motion_compensation = false;
  Rig blind(p);
  blind.wind_I_mps = rig.wind_I_mps;
  blind.move = rig.move;
  EXPECT_GT(blind.run_until(90.0).intensity, 0.05);
}

// A nacelle turned out of the wind: with record 24 the projection and c_TI follow, wherever the
// wind blows in frame I, and all beams agree on the wind speed.
TEST(TiEstimator, YawErrorGivesTheWindDirection) {
  TiEstimatorParams p = params();
  p.use_yaw_error = true;
  p.table_yaw_errors_rad = {rad_from_deg(5.0), rad_from_deg(10.0), rad_from_deg(15.0)};
  for (const double wind_rad : {0.0, 0.4}) {
    Rig rig(p);
    const double nacelle_rad = wind_rad - rad_from_deg(10.0);
    rig.yaw_error_rad = wind_rad - nacelle_rad;
    rig.move = [&](double, LidarMeasurement& m) { m.yaw_rad = kPi + nacelle_rad; };
    rig.wind_I_mps = [&](double t) {
      const double u = sine_wind(t).x;
      return Vec3{u * std::cos(wind_rad), u * std::sin(wind_rad), 0.0};
    };
    const auto out = rig.run_until(100.0);
    EXPECT_NEAR(out.mean_speed_mps, kSpeed_mps, 1e-4);
    const Correction model(p.correction);
    double factor = 0.0;
    for (const Vec3& n : p.beam_dir_L) {
      factor += 0.25 * model.c_ti(n, kSpeed_mps, rig.yaw_error_rad) *
                std::abs(beam_in_wind(n, rig.yaw_error_rad).x);
    }
    const double std_mps = kAmplitude_mps * std::sqrt(0.5 * 60.0 / 59.0);
    EXPECT_NEAR(out.intensity / (factor * std_mps / kSpeed_mps), 1.0, 2e-3) << wind_rad;
  }
}

// A third of the samples lost at random (blades): still valid and close; the scatter of a
// standard deviation from 40 of 60 samples of a sine is below 4 % per series.
TEST(TiEstimator, LivesWithLostSamples) {
  Rig rig(params());
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> chance;
  rig.tamper = [&](LidarMeasurement& m) {
    for (LidarGate& gate : m.gates) gate.valid = chance(random) > 1.0 / 3.0;
    return true;
  };
  const auto out = rig.run_until(120.0);
  EXPECT_EQ(out.filled_series, 12);
  EXPECT_NEAR(out.intensity / expected_intensity(params()), 1.0, 0.04);
}

// One gate dead: the others go on without it.
TEST(TiEstimator, LeavesADeadGateOut) {
  Rig rig(params());
  rig.tamper = [](LidarMeasurement& m) {
    m.gates[2] = {160.0, std::nan(""), false, 0.0};
    return true;
  };
  const auto out = rig.run_until(80.0);
  EXPECT_EQ(out.filled_series, 8);
  EXPECT_NEAR(out.intensity / expected_intensity(params()), 1.0, 2e-3);
}

// A valid flag on something that is no speed does not let it in.
TEST(TiEstimator, NoSpeedIsNoSample) {
  for (const double lie : {std::nan(""), 1.0e30, -999.0, HUGE_VAL}) {
    Rig rig(params());
    rig.tamper = [&](LidarMeasurement& m) {
      m.gates[1].speed_mps = lie;
      return true;
    };
    const auto out = rig.run_until(80.0);
    EXPECT_EQ(out.filled_series, 8) << lie;
    EXPECT_NEAR(out.intensity / expected_intensity(params()), 1.0, 2e-3) << lie;
  }
}

// A silent lidar: old samples leave on time, half a window later the estimate is gone, and after
// the return it needs a full window again because nothing was left.
TEST(TiEstimator, SilenceEmptiesTheWindowOnTime) {
  Rig rig(params());
  rig.run_until(100.0);
  rig.tamper = [](LidarMeasurement&) { return false; };
  EXPECT_TRUE(rig.run_until(129.0).valid());
  EXPECT_FALSE(rig.run_until(131.0).valid());
  EXPECT_EQ(rig.run_until(165.0).filled_series, 0);
  rig.tamper = [](LidarMeasurement&) { return true; };
  EXPECT_FALSE(rig.run_until(224.5).valid());
  const auto out = rig.run_until(226.0);
  EXPECT_TRUE(out.valid());
  EXPECT_NEAR(out.intensity / expected_intensity(params()), 1.0, 2e-3);
}

// Outside the table of wind speeds there is no estimate.
TEST(TiEstimator, NoEstimateOutsideTheTable) {
  Rig rig(params());
  rig.wind_I_mps = [](double) { return Vec3{2.0, 0.0, 0.0}; };
  const auto out = rig.run_until(80.0);
  EXPECT_TRUE(out.outside_table);
  EXPECT_FALSE(out.valid());
  EXPECT_NEAR(out.mean_speed_mps, 2.0, 1e-4);
}

// What does not fit the input file is told with the step that brought it.
TEST(TiEstimator, TellsWhatDoesNotFit) {
  Rig rig(params());
  EXPECT_FALSE(rig.step().other_direction);
  rig.tamper = [](LidarMeasurement& m) {
    m.gate_count = 5;
    m.beam_dir_L = beam_direction(rad_from_deg(18.0), rad_from_deg(12.5));
    return true;
  };
  rig.run_until(0.25);
  const auto out = rig.step();
  EXPECT_TRUE(out.other_direction);
  EXPECT_TRUE(out.too_many_gates);
}

// A lidar twice as fast as ScanTime says: told, what has room is used, and T stays T.
TEST(TiEstimator, FasterThanScanTime) {
  TiEstimatorParams p = params();
  p.scan_time_s = 2.0;
  Rig rig(p);
  bool told = false;
  for (int i = 0; i < 8000; ++i) told = rig.step().no_room || told;
  const auto out = rig.step();
  EXPECT_TRUE(told);
  EXPECT_TRUE(out.valid());
  EXPECT_NEAR(out.mean_speed_mps, kSpeed_mps, 0.5);
}

// Saved and loaded in mid-window, the estimator goes on bit by bit.
TEST(TiEstimator, ContinuesFromASavedState) {
  TiEstimatorParams p = params();
  p.use_yaw_error = true;
  p.table_yaw_errors_rad = {-0.1, 0.0, 0.1};
  Rig rig(p);
  rig.yaw_error_rad = 0.02;
  rig.run_until(70.1);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  rig.state.visit(save);
  Rig copy = rig;
  copy.state = copy.estimator.initial_state();
  StateArchive load{std::span<const std::byte>(bytes)};
  copy.state.visit(load);
  ASSERT_TRUE(load.complete());
  for (int i = 0; i < 8000; ++i) ASSERT_TRUE(same(rig.step(), copy.step())) << i;
}

// No step allocates, with or without a measurement, filling, filled or emptying.
TEST(TiEstimator, StepsDoNotAllocate) {
  if (!test::kCountsAllocations) GTEST_SKIP() << "the sanitizer owns malloc";
  Rig rig(params());
  rig.run_until(1.0);
  const test::NoAllocGuard guard;
  rig.run_until(130.0);
  rig.tamper = [](LidarMeasurement&) { return false; };
  rig.run_until(200.0);
  EXPECT_EQ(guard.allocations(), 0U);
}

const IntensityEstimate& of(const TiEstimator::Outputs& out, IntensitySource source) {
  return out.estimates[static_cast<std::size_t>(source)];
}

TiEstimatorParams with_competitors() {
  TiEstimatorParams p = params();
  p.uncorrected = true;
  for (SignalIntensityParams* s : {&p.anemometer, &p.turbine}) {
    s->used = true;
    s->statistics = p.statistics();
    s->statistics.beams = s->statistics.gates = 1;
    s->statistics.scan_time_s = kSignalInterval_s;
  }
  p.rotor_radius_m = 65.0;
  return p;
}

/// Lidar, anemometer and rotor all in the sine.
TiEstimator::Outputs run_competitors(const TiEstimatorParams& p, double until_s) {
  const TiEstimator estimator(p, kTimeStep_s);
  TiEstimator::State state = estimator.initial_state();
  Rig rig(p);  // for its measurements
  TiEstimator::Outputs out;
  for (int i = 0; i * kTimeStep_s < until_s - 1e-9; ++i) {
    rig.step();
    TiEstimator::Inputs in;
    in.time_s = i * kTimeStep_s;
    if (i % kStepsPerBeam == 0) in.measurement = &rig.measurement;
    in.anemometer_mps = in.turbine_rews_mps = sine_wind(in.time_s).x;
    in.ldp_mean_speed_mps = 12.0;
    out = estimator.step(in, state);
  }
  return out;
}

// In a wind that is the same everywhere: uncorrected lidar and anemometer have its plain ratio of
// standard deviation and mean, the turbine that times sigma_u over sigma_REWS (interpolated in the
// table: 0.3 %).
TEST(TiEstimator, Competitors) {
  const TiEstimatorParams p = with_competitors();
  const auto out = run_competitors(p, 100.0);
  const double ratio = kAmplitude_mps / kSpeed_mps * std::sqrt(0.5);
  const Correction c(p.correction);
  const double rotor =
      std::sqrt(c.u_variance(kSpeed_mps) / c.rews_variance(kSpeed_mps, 65.0, p.turbine_cutoff_hz));
  EXPECT_GT(rotor, 1.2);
  EXPECT_NEAR(of(out, IntensitySource::Uncorrected).intensity / ratio, std::sqrt(60.0 / 59.0),
              1e-4);
  EXPECT_NEAR(of(out, IntensitySource::Anemometer).intensity / ratio, std::sqrt(240.0 / 239.0),
              1e-4);
  EXPECT_NEAR(of(out, IntensitySource::Turbine).intensity / ratio / rotor, std::sqrt(240.0 / 239.0),
              4e-3);
  EXPECT_EQ(of(out, IntensitySource::Lidar).intensity, out.intensity);
}

// Sampled every whole number of steps: a time step that does not divide the interval loses none of
// the samples that MinimumFill counts. No estimate outside the table of the turbine's correction.
TEST(TiEstimator, CompetitorsAtAnyTimeStep) {
  constexpr double kLongStep_s = 0.2;  // sampled every 0.4 s
  TiEstimatorParams p = with_competitors();
  for (SignalIntensityParams* s : {&p.anemometer, &p.turbine}) s->statistics.minimum_fill = 0.9;
  for (const double mean_mps : {kSpeed_mps, 2.0}) {
    const TiEstimator estimator(p, kLongStep_s);
    TiEstimator::State state = estimator.initial_state();
    TiEstimator::Outputs out;
    for (int i = 0; i < 500; ++i) {
      TiEstimator::Inputs in;
      in.time_s = i * kLongStep_s;
      in.anemometer_mps = in.turbine_rews_mps = mean_mps + std::sin(0.7 * in.time_s);
      out = estimator.step(in, state);
    }
    EXPECT_TRUE(of(out, IntensitySource::Anemometer).valid()) << mean_mps;
    EXPECT_EQ(of(out, IntensitySource::Turbine).valid(), mean_mps == kSpeed_mps);
  }
}

// The competitors leave the lidar's estimate as it is, and the power level with it; each of them
// drives the level if it is asked to.
TEST(TiEstimator, PowerLevelSource) {
  TiEstimatorParams p = with_competitors();
  p.power_level.rate_1ps = 1.0;
  Rig alone(params());
  EXPECT_EQ(run_competitors(p, 100.0).intensity, alone.run_until(100.0).intensity);
  for (const auto source : {IntensitySource::Lidar, IntensitySource::Uncorrected,
                            IntensitySource::Anemometer, IntensitySource::Turbine}) {
    p.power_level_source = source;
    const auto out = run_competitors(p, 100.0);
    EXPECT_NEAR(out.power_level,
                power_level_for(of(out, source).intensity, kSpeed_mps, p.power_level), 1e-12);
  }
}

// U from LDP: in the denominator, and where c_TI is looked up; none without one.
TEST(TiEstimator, MeanSpeedOfLdp) {
  TiEstimatorParams p = with_competitors();
  const auto own = run_competitors(p, 100.0);
  p.mean_speed_of_ldp = true;
  const auto out = run_competitors(p, 100.0);
  EXPECT_EQ(out.mean_speed_mps, 12.0);
  const Vec3 n = p.beam_dir_L[0];
  const Correction c(p.correction);
  EXPECT_NEAR(out.intensity / own.intensity,
              kSpeed_mps / 12.0 * c.c_ti(n, 12.0, 0.0) / c.c_ti(n, kSpeed_mps, 0.0), 4e-3);
  Rig rig(p);  // hears nothing from LDP
  const auto none = rig.run_until(100.0);
  EXPECT_FALSE(none.valid());
  EXPECT_TRUE(none.ldp_missing);
}

// A yaw error that is never known is not taken for none; gaps in it are.
TEST(TiEstimator, YawErrorUnknown) {
  TiEstimatorParams p = params();
  p.use_yaw_error = true;
  p.table_yaw_errors_rad = {-0.2, 0.0, 0.2};
  Rig never(p);
  never.yaw_error_rad = std::nan("");
  EXPECT_TRUE(never.run_until(100.0).ldp_missing);
  Rig late(p);
  late.yaw_error_rad = 0.1;
  late.run_until(70.0);
  late.yaw_error_rad = std::nan("");
  EXPECT_TRUE(late.run_until(100.0).valid());
}

// The gates count by their weights: one in still air next to two in the sine.
TEST(TiEstimator, GateWeights) {
  TiEstimatorParams p = params();
  p.gate_weights = {2.0, 1.0, 1.0};
  Rig rig(p);
  rig.tamper = [](LidarMeasurement& m) {
    m.gates[0].speed_mps = kSpeed_mps * m.beam_dir_L.x;
    return true;
  };
  EXPECT_NEAR(rig.run_until(100.0).intensity / expected_intensity(p), 0.5, 1e-3);
}

}  // namespace
}  // namespace lac
