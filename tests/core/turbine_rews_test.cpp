// SPDX-License-Identifier: Apache-2.0
#include "core/turbine_rews.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "support/error_text.hpp"

namespace lac {
namespace {

using testing::HasSubstr;

constexpr char kTable[] = LAC_SOURCE_DIR "/config/turbines/nrel5mw/cp_ct.txt";
constexpr double kStep_s = 0.0125;
constexpr double kGearbox = 97.0;
constexpr double kInertia_kgm2 = 4.3703e7;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

const RotorTable& table() {
  static const RotorTable loaded = RotorTable::load(kTable);
  return loaded;
}
TurbineRewsParams params() {
  TurbineRewsParams p{{table(), 63.0, 1.225}};
  p.inertia_kgm2 = kInertia_kgm2;
  p.gearbox_ratio = kGearbox;
  p.gearbox_efficiency = 0.96;
  return p;
}
double quotient(double tsr, double pitch_rad) {
  return table().cp(tsr, pitch_rad) / (tsr * tsr * tsr);
}

/// The torque that holds a rotor at rest in this wind, generator side.
TurbineRews::Inputs at_rest(double wind_mps, double speed_radps, double pitch_rad) {
  const TurbineRewsParams p = params();
  TurbineRews::Inputs in;
  in.generator_speed_radps = kGearbox * speed_radps;
  in.generator_torque_Nm =
      p.rotor.torque_Nm(wind_mps, speed_radps, pitch_rad) * p.gearbox_efficiency / kGearbox;
  in.pitch_rad = pitch_rad;
  return in;
}

// Between the nodes in both directions, wherever the rotor turns a generator: what goes in comes
// out.
TEST(TsrLookup, InvertsTheBilinearTable) {
  const TsrLookup lookup(table());
  int checked = 0;
  for (double pitch_deg = -4.9; pitch_deg < 30.0; pitch_deg += 0.37) {
    for (double tsr = 4.03; tsr < 14.9; tsr += 0.17) {
      const double pitch_rad = rad_from_deg(pitch_deg);
      const double found = lookup.tsr(quotient(tsr, pitch_rad), pitch_rad);
      if (std::isnan(found) || table().cp(tsr, pitch_rad) < 0.0) continue;
      EXPECT_NEAR(found, tsr, 1e-6) << pitch_deg;
      ++checked;
    }
  }
  EXPECT_GT(checked, 2500);
}

// Beyond the table there is nothing: pitch, the largest quotient, the last tip-speed ratio,
// rubbish.
TEST(TsrLookup, NothingOutside) {
  const TsrLookup lookup(table());
  const double pitch_rad = rad_from_deg(5.0), inside = quotient(6.0, pitch_rad);
  EXPECT_TRUE(std::isfinite(lookup.tsr(inside, pitch_rad)));
  EXPECT_TRUE(std::isnan(lookup.tsr(inside, rad_from_deg(-5.01))));
  EXPECT_TRUE(std::isnan(lookup.tsr(inside, rad_from_deg(30.01))));
  EXPECT_TRUE(std::isnan(lookup.tsr(1.0, pitch_rad)));
  EXPECT_TRUE(std::isnan(lookup.tsr(-1.0, pitch_rad)));
  EXPECT_TRUE(std::isnan(lookup.tsr(kNothing, pitch_rad)));
  EXPECT_TRUE(std::isnan(lookup.tsr(inside, kNothing)));
}

// A rise of the quotient from stall to its largest value is not used: the falling side is.
TEST(TsrLookup, TakesTheFallingBranch) {
  const RotorTable humped({1.0, 2.0, 3.0, 4.0}, {0.0, 0.1},
                          {0.1, 0.1, 1.6, 1.6, 2.7, 2.7, 3.2, 3.2}, std::vector<double>(8, 0.0));
  const TsrLookup lookup(humped);  // quotients 0.1, 0.2, 0.1, 0.05
  EXPECT_NEAR(lookup.tsr(0.1, 0.05), 3.0, 1e-7);
  EXPECT_GT(lookup.tsr(0.19, 0.05), 2.0);
  EXPECT_TRUE(std::isnan(lookup.tsr(0.201, 0.05)));
  const RotorTable at_rest({0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 0.1},
                           {0.0, 0.0, 0.1, 0.1, 1.6, 1.6, 2.7, 2.7, 3.2, 3.2},
                           std::vector<double>(10, 0.0));
  EXPECT_NEAR(TsrLookup(at_rest).tsr(0.1, 0.05), 3.0, 1e-7);  // the row of a rotor at rest is none
  const std::vector<double> rising{0.1, 0.1, 8.0, 8.0};
  EXPECT_THAT(test::error_text([&] {
                const RotorTable t({1.0, 2.0}, {0.0, 0.1}, rising, std::vector<double>(4, 0.0));
                const TsrLookup l(t);
              }),
              HasSubstr("does not fall"));
}

// At rest the wind that goes with speed, torque, pitch and losses, once the filter has settled.
TEST(TurbineRewsTest, SteadyWind) {
  const TurbineRews rews(params(), kStep_s);
  for (const double wind_mps : {6.0, 9.0, 13.0, 18.0, 24.0}) {
    const double pitch_rad = rad_from_deg(wind_mps > 11.0 ? 1.9 * (wind_mps - 11.0) : 0.0);
    const double speed_radps = std::min(1.26, wind_mps * 7.5 / 63.0);
    TurbineRews::State state;
    double v_mps = 0.0;
    for (int i = 0; i < 90; ++i)
      v_mps = rews.step(at_rest(wind_mps, speed_radps, pitch_rad), state);
    EXPECT_NEAR(v_mps, wind_mps, 1e-6 * wind_mps);
  }
}

// The rotor of the equation in a sine of wind, constant torque: amplitude and delay of the
// low-pass, no matter that the pitch moves too.
TEST(TurbineRewsTest, DelayIsKnown) {
  const TurbineRewsParams p = params();
  const TurbineRews rews(p, kStep_s);
  const double w = radps_from_hz(0.05);
  const auto wind = [&](double t) { return 16.0 + 0.3 * std::sin(w * t); };
  const auto pitch = [&](double t) { return rad_from_deg(12.0) + 0.003 * std::sin(w * t + 0.4); };
  TurbineRews::Inputs in = at_rest(16.0, 1.26, rad_from_deg(12.0));
  TurbineRews::State state;
  double speed_radps = 1.26, in_phase = 0.0, across = 0.0;
  const int run_in = 8000, steps = run_in + 1600 * 3;  // three periods of 20 s
  for (int n = 0; n < steps; ++n) {
    const double t = n * kStep_s;
    in.generator_speed_radps = kGearbox * speed_radps;
    in.pitch_rad = pitch(t);
    const double v_mps = rews.step(in, state);
    if (n >= run_in) {
      in_phase += v_mps * std::sin(w * t);
      across += v_mps * std::cos(w * t);
    }
    for (int k = 0; k < 10; ++k) {
      const double at = t + (k + 0.5) * 0.1 * kStep_s;
      const double torque_Nm = p.rotor.torque_Nm(wind(at), speed_radps, pitch(at)) -
                               kGearbox / p.gearbox_efficiency * in.generator_torque_Nm;
      speed_radps += torque_Nm / p.inertia_kgm2 * 0.1 * kStep_s;
    }
  }
  const double gain = std::hypot(in_phase, across) / (0.5 * (steps - run_in) * 0.3);
  EXPECT_NEAR(gain, 1.0 / std::hypot(1.0, 0.05 / p.low_pass_hz), 0.005);
  EXPECT_NEAR(std::atan2(-across, in_phase) / w, std::atan(0.05 / p.low_pass_hz) / w, 0.02);
  EXPECT_NEAR(rews.delay_s(), 1.0 / radps_from_hz(p.low_pass_hz), 0.01);
}

// Off, standing, not a number: nothing, and afterwards anew.
TEST(TurbineRewsTest, NothingWithoutGenerator) {
  const TurbineRews rews(params(), kStep_s);
  const TurbineRews::Inputs good = at_rest(18.0, 1.26, rad_from_deg(15.0));
  TurbineRews::State state;
  const auto settle = [&] {
    double v_mps = 0.0;
    for (int i = 0; i < 90; ++i) v_mps = rews.step(good, state);
    return v_mps;
  };
  for (double TurbineRews::Inputs::*field :
       {&TurbineRews::Inputs::generator_speed_radps, &TurbineRews::Inputs::generator_torque_Nm,
        &TurbineRews::Inputs::pitch_rad}) {
    EXPECT_NEAR(settle(), 18.0, 1e-6);
    TurbineRews::Inputs bad = good;
    bad.*field = kNothing;
    EXPECT_TRUE(std::isnan(rews.step(bad, state)));
    EXPECT_TRUE(std::isnan(rews.step(good, state)));
  }
  TurbineRews::Inputs off = good;
  off.generator_torque_Nm = 0.0;
  EXPECT_TRUE(std::isnan(rews.step(off, state)));
  EXPECT_NEAR(settle(), 18.0, 1e-6);
  off = good;
  off.usable = false;
  EXPECT_TRUE(std::isnan(rews.step(off, state)));
}

// Mistakes are told with file, line and key.
TEST(TurbineRewsParamsTest, RefusesMistakes) {
  const std::string text = std::string("\"") + kTable +
                           "\" ! RotorTable -\n63 ! RotorRadius -\n4e7 ! InertiaLowSpeedShaft -\n"
                           "97 ! GearboxRatio -\n";
  const auto read = [](const std::string& t) {
    InputFile in = InputFile::parse(t, "a.IN");
    return TurbineRewsParams::read(in);
  };
  EXPECT_EQ(read(text).low_pass_hz, 0.5);
  EXPECT_EQ(read(text).rotor.air_density_kgpm3, 1.225);
  EXPECT_THAT(test::error_text([&] { read(text + "0.4 ! GearboxEfficiency -\n"); }),
              HasSubstr("a.IN:5: GearboxEfficiency"));
  EXPECT_THAT(test::error_text([&] { read("none.txt ! RotorTable -\n"); }),
              HasSubstr("a.IN:1: RotorTable"));
  InputFile in = InputFile::parse(text + "50 ! TurbineLowPass -\n", "a.IN");
  const TurbineRewsParams p = TurbineRewsParams::read(in);
  EXPECT_THAT(test::error_text([&] { p.check_time_step(in, 0.0125); }),
              HasSubstr("a.IN:5: TurbineLowPass"));
}

}  // namespace
}  // namespace lac
