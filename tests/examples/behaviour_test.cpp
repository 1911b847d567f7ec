// SPDX-License-Identifier: Apache-2.0
// What the three examples do to the records, against closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/units.hpp"
#include "examples/example_library.hpp"
#include "support/temp_folder.hpp"

namespace lac::test {
namespace {

using std::numbers::pi;

/// Amplitude of record 53 after the filter, for a sine of amplitude 1.
double filtered_amplitude(const DisconLibrary& library, double frequency_Hz) {
  ExampleHost h(library, kTowerFilter.input_file());
  double largest = 0.0;
  for (int n = 0; n < 16000; ++n) {
    const double x = std::sin(2.0 * pi * frequency_Hz * 0.0125 * n);
    h.set(Rec::TowerForeAftAcceleration, static_cast<float>(x));
    h.call(n == 0 ? LAC_STATUS_FIRST : LAC_STATUS_STEP);
    EXPECT_EQ(h.at(3341), h.get(Rec::TowerForeAftAcceleration));
    if (n > 8000) largest = std::max(largest, std::abs(static_cast<double>(h.at(3341))));
  }
  return largest;
}

// Gain over frequency: the continuous filters at the frequencies that the bilinear transform
// with a fixed point at each centre maps to.
TEST(TowerFilterExample, Gain) {
  const DisconLibrary library = kTowerFilter.open();
  const auto warped = [](double f_Hz) { return std::tan(pi * f_Hz * 0.0125); };
  for (const double f_Hz : {0.1, 0.32, 0.55, 0.605, 1.5, 4.0}) {
    const std::complex<double> notch(0.0, warped(f_Hz) / warped(0.605));
    const std::complex<double> low(0.0, warped(f_Hz) / warped(1.5));
    const auto gain =
        (notch * notch + 1.0) / (notch * notch + 0.4 * notch + 1.0) / (low * low + 1.4 * low + 1.0);
    EXPECT_NEAR(filtered_amplitude(library, f_Hz), std::abs(gain), 2e-3) << f_Hz << " Hz";
  }
}

// A constant passes from the first call on.
TEST(TowerFilterExample, NoTransientAtTheStart) {
  const DisconLibrary library = kTowerFilter.open();
  ExampleHost h(library, kTowerFilter.input_file());
  for (int n = 0; n < 100; ++n) {
    h.set(Rec::TowerForeAftAcceleration, 0.7f);
    h.call(n == 0 ? LAC_STATUS_FIRST : LAC_STATUS_STEP);
    EXPECT_NEAR(h.get(Rec::TowerForeAftAcceleration), 0.7f, 1e-6f);
  }
}

float level_at(ExampleHost& h, double speed_rpm, double duration_s) {
  h.set(Rec::GeneratorSpeed, static_cast<float>(radps_from_rpm(speed_rpm)));
  const auto steps = std::lround(duration_s / 0.0125);
  for (long n = 0; n < steps; ++n) h.call(LAC_STATUS_STEP);
  return h.get(Rec::PowerLevel);
}

// One step down per event, however long it lasts; back at 0.02 per minute; never below 0.7.
TEST(SpeedSupervisorExample, LevelOverEvents) {
  const DisconLibrary library = kSpeedSupervisor.open();
  ExampleHost h(library, kSpeedSupervisor.input_file());
  h.call(LAC_STATUS_FIRST);
  EXPECT_EQ(h.get(Rec::PowerLevel), 1.0f);
  EXPECT_EQ(h.get(Rec::PowerLevelValid), 1.0f);
  EXPECT_NEAR(level_at(h, 1325.0, 0.0125), 0.9f, 1e-6f);
  EXPECT_THAT(h.message(), testing::HasSubstr("power level lowered to 0.9"));
  EXPECT_NEAR(level_at(h, 1325.0, 60.0), 0.92f, 1e-5f);
  EXPECT_EQ(h.message(), "");
  EXPECT_NEAR(level_at(h, 1250.0, 60.0), 0.94f, 1e-5f);  // between the limits: still one event
  EXPECT_NEAR(level_at(h, 1325.0, 60.0), 0.96f, 1e-5f);
  EXPECT_NEAR(level_at(h, 1190.0, 60.0), 0.98f, 1e-5f);
  for (int event = 0; event < 5; ++event) {
    level_at(h, 1325.0, 0.0125);
    level_at(h, 1190.0, 0.0125);
  }
  EXPECT_NEAR(h.get(Rec::PowerLevel), 0.7f, 1e-4f);
  EXPECT_EQ(level_at(h, 1190.0, 1000.0), 1.0f);
}

// Two turbines in one image, told apart by their root names.
TEST(SpeedSupervisorExample, TurbinesDoNotMeet) {
  const DisconLibrary library = kSpeedSupervisor.open();
  ExampleHost a(library, kSpeedSupervisor.input_file());
  TestHost b(library.entry(), kSpeedSupervisor.input_file(), "other.SrvD", kPrivateArraySize);
  b.set(Rec::ChainVersion, kChainLayoutVersion);
  a.call(LAC_STATUS_FIRST);
  b.call(LAC_STATUS_FIRST);
  level_at(a, 1325.0, 0.0125);
  b.call(LAC_STATUS_STEP);
  EXPECT_NEAR(a.get(Rec::PowerLevel), 0.9f, 1e-6f);
  EXPECT_EQ(b.get(Rec::PowerLevel), 1.0f);
}

// Under a host that is not the master there is no power level: said so.
TEST(SpeedSupervisorExample, NeedsTheMaster) {
  const DisconLibrary library = kSpeedSupervisor.open();
  TestHost h(library.entry(), kSpeedSupervisor.input_file());
  EXPECT_LT(h.call(LAC_STATUS_FIRST), 0);
  EXPECT_THAT(h.message(), testing::HasSubstr("array of the LAC master alone"));
}

class MinimumPitchExample : public testing::Test {
 protected:
  void SetUp() override {
    if (!kMinimumPitch.built) GTEST_SKIP() << kNoFortran;
    library = kMinimumPitch.open();
  }
  /// Demanded pitch after `steps` calls at constant wind, with 1 deg asked for.
  double pitch_deg(ExampleHost& h, double wind_mps, int steps) const {
    h.set(Rec::HubWindSpeed, static_cast<float>(wind_mps));
    for (int n = 0; n < steps; ++n) {
      for (int r = 42; r <= 45; ++r) h.put(r, static_cast<float>(rad_from_deg(1.0)));
      EXPECT_EQ(h.call(started_ ? LAC_STATUS_STEP : LAC_STATUS_FIRST), 0) << h.message();
      started_ = true;
      for (int r = 43; r <= 45; ++r) EXPECT_EQ(h.at(r), h.at(42));
    }
    return deg_from_rad(static_cast<double>(h.at(42)));
  }

  DisconLibrary library;
  mutable bool started_ = false;
};

// Interpolated between the points, constant outside, never below what was asked for.
TEST_F(MinimumPitchExample, Table) {
  const std::pair<double, double> cases[] = {{5.0, 1.0},   {9.5, 1.0},  {10.5, 1.5},
                                             {11.25, 2.5}, {13.0, 3.5}, {40.0, 3.5}};
  for (const auto& [wind_mps, expected_deg] : cases) {
    started_ = false;
    ExampleHost h(library, kMinimumPitch.input_file());
    EXPECT_NEAR(pitch_deg(h, wind_mps, 3), expected_deg, 1e-5) << wind_mps;
  }
}

// The low-pass of the wind speed: 1 - exp(-t/T) of a step, T = 1/(2 pi 0.02 Hz).
TEST_F(MinimumPitchExample, LowPass) {
  ExampleHost h(library, kMinimumPitch.input_file());
  pitch_deg(h, 10.5, 1);
  pitch_deg(h, 12.0, 800);  // 10 s
  const double share = 1.0 - std::exp(-2.0 * pi * 0.02 * 10.0);
  EXPECT_NEAR(deg_from_rad(static_cast<double>(h.at(3342))), 1.5 + 2.0 * share, 1e-4);
}

// A wind speed that is not there (not a number) is waited out at the last value.
TEST_F(MinimumPitchExample, MissingWindSpeed) {
  ExampleHost h(library, kMinimumPitch.input_file());
  const double before = pitch_deg(h, 11.0, 10);
  EXPECT_EQ(pitch_deg(h, std::nan(""), 10), before);
}

}  // namespace
}  // namespace lac::test
