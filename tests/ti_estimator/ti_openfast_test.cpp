// SPDX-License-Identifier: Apache-2.0
// The built library on OpenFAST's own lidar block, with the shipped input file.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "support/discon_caller.hpp"
#include "support/error_text.hpp"
#include "support/openfast_lidar_host.hpp"
#include "ti_estimator/ti_estimator.hpp"

namespace lac {
namespace {

const char* const kShipped = LAC_SOURCE_DIR "/config/openfast/ti_estimator.IN";
constexpr double kAmplitude_mps = 3.0;
constexpr double kPeriod_s = 12.0;

TiEstimatorParams shipped() {
  InputFile in = InputFile::load(kShipped);
  return TiEstimatorParams::read(in);
}

/// A sine on 16 m/s, its phase another one at each point: T holds 15 whole periods.
double sine_wind(double t, double x_m) {
  return 16.0 + kAmplitude_mps * std::sin(2.0 * kPi * t / kPeriod_s + 0.1 * x_m);
}

/// TI of record 3311 after T in a host with this order of extrapolation.
double intensity_after_window(int order, int& messages) {
  test::OpenFastLidarHost host;
  host.order = order;
  host.wind_mps = sine_wind;
  test::DisconCaller caller("liblac_ti_estimator", kShipped);
  caller.set_time_step(host.time_step_s);
  caller.swap().set(Rec::HubWindSpeed, 16.0);
  for (long k = 0; k < 190 * 160; ++k) {
    host.fill(caller.swap(), k);
    const int fail = caller.call(k == 0 ? 0 : 1);
    EXPECT_GE(fail, 0) << caller.message();
    messages += fail != 0 ? 1 : 0;
  }
  EXPECT_EQ(caller.swap().get(Rec::TurbulenceValid), 1.0);
  return caller.swap().get(Rec::TurbulenceIntensity);
}

// One beam straight up-wind, five gates, the scan as long as the measurement interval.
TEST(TiOpenFast, ShippedFile) {
  const TiEstimatorParams p = shipped();
  ASSERT_EQ(p.beam_dir_L.size(), 1U);
  EXPECT_EQ(p.beam_dir_L[0], (Vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(p.number_of_gates, 5);
  EXPECT_EQ(p.scan_time_s, 0.25);
  EXPECT_EQ(p.correction.scan_rate_hz, 4.0);
  EXPECT_EQ(p.reader.openfast.interpolation_order, 2);
  EXPECT_EQ(p.reader.openfast.rotor_position_x_m, -5.0);
}

// The standard deviation of a sine over whole periods, times c_TI: nothing of the spikes is in it.
TEST(TiOpenFast, IntensityOfASine) {
  int messages = 0;
  const TiEstimatorParams p = shipped();
  const double c_ti = Correction(p.correction).c_ti(p.beam_dir_L[0], 16.0, 0.0);
  const double expected = c_ti * kAmplitude_mps * std::sqrt(0.5 * 720.0 / 719.0) / 16.0;
  EXPECT_NEAR(intensity_after_window(2, messages) / expected, 1.0, 2e-3);
  EXPECT_EQ(messages, 0);
}

// Left as they come the spikes would be: the same file in a host of another order reads more
// turbulence, and says once that the order is not that of the host.
TEST(TiOpenFast, WrongOrderShows) {
  int messages = 0;
  const double right = intensity_after_window(2, messages);
  const double wrong = intensity_after_window(1, messages);
  EXPECT_EQ(messages, 1);
  EXPECT_NE(wrong, right);
}

// The lidar does not turn with the nacelle, so its yaw error is no yaw error of the lidar; and the
// block says itself where the points lie.
TEST(TiOpenFast, KeysThatDoNotApply) {
  const auto error = [](const std::string& more) {
    InputFile in = InputFile::parse(
        "openfast ! LidarLayout\n2 ! InterpolationOrder\n-5 ! RotorPositionX\n"
        "0.25 ! MeasurementInterval\n90 ! HubHeight\n" +
            more,
        "ti.IN");
    return test::error_text([&] { TiEstimatorParams::read(in); });
  };
  EXPECT_EQ(error(""), "no error");
  EXPECT_NE(error("true ! UseYawError\n").find("ti.IN:6: UseYawError: not with"),
            std::string::npos);
  EXPECT_NE(error("0 ! BeamAzimuth\n").find("ti.IN:6: BeamAzimuth: not with"), std::string::npos);
  EXPECT_NE(error("5 ! NumberOfGates\n").find("ti.IN:6: NumberOfGates: not with"),
            std::string::npos);
}

}  // namespace
}  // namespace lac
