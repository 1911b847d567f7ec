// SPDX-License-Identifier: Apache-2.0
#include "monitor/monitor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "monitor/random_wind.hpp"
#include "support/error_text.hpp"

namespace lac {
namespace {

using testing::HasSubstr;

constexpr double kStep_s = 0.05;
constexpr double kLead_s = 4.0;
constexpr double kWindow_s = 1.0;
const std::string kShipped = LAC_SOURCE_DIR "/config/nrel5mw/monitor.IN";

MonitorParams shipped() {
  InputFile in = InputFile::load(kShipped);
  return MonitorParams::read(in);
}

/// A rotor at constant speed and pitch in a known wind, and a lidar that says what is asked.
struct Box {
  MonitorParams params = shipped();
  unsigned seed = 1;
  double lead_error_s = 0.0;  // the wind comes that much later than the lead says
  double bias = 1.0;
  double noise_mps = 0.0;    // slow noise of the lidar's own
  double common = 1.0;       // share of the lidar's deviations that are the rotor's
  double acts_late_s = 0.0;  // the buffer is that much too long
  bool feedforward = true;
  double trim_s = 0.0;  // in use

  Monitor::Inputs inputs(double t) const {
    static const double speed_radps = 1.2, pitch_rad = rad_from_deg(12.0);
    const test::RandomWind &wind = own(), &other = others();
    const auto lidar = [&](double at) {
      return bias * (16.0 + common * (wind.at(at) - 16.0) + noise_mps * (other.at(at) - 16.0));
    };
    Monitor::Inputs in;
    in.turbine.generator_speed_radps = 97.0 * speed_radps;
    in.turbine.pitch_rad = pitch_rad;
    in.turbine.generator_torque_Nm =
        params.turbine.rotor.torque_Nm(wind.at(t), speed_radps, pitch_rad) / 97.0;
    in.lidar_valid = true;
    in.lead_s = kLead_s;
    in.window_s = kWindow_s;
    const double comes_s = kLead_s - 0.5 * kWindow_s + lead_error_s;
    in.lidar_mps = lidar(t + comes_s);
    if (feedforward) {
      in.cutoff_hz = 1000.0;  // no filter
      in.buffer_time_s = kLead_s - 0.5 * kWindow_s - params.actuator_delay_s + acts_late_s + trim_s;
      in.buffered_mps = lidar(t + params.actuator_delay_s + lead_error_s - acts_late_s - trim_s);
    }
    return in;
  }
  /// With what is done to the inputs and looked at in the outputs on the way.
  Monitor::Outputs fly(
      double duration_s,
      const std::function<void(double, Monitor::Inputs&)>& spoil = [](double, auto&) {},
      const std::function<void(double, const Monitor::Outputs&)>& watch = [](double, auto&) {}) {
    const Monitor monitor(params, kStep_s);
    Monitor::State state = monitor.initial_state();
    Monitor::Outputs out;
    const int steps = static_cast<int>(duration_s / kStep_s);
    for (int n = 0; n < steps; ++n) {
      const double t = n * kStep_s;
      trim_s += (out.trim_s - trim_s) * kStep_s / 10.0;  // as ffp follows it
      Monitor::Inputs in = inputs(t);
      spoil(t, in);
      out = monitor.step(in, state);
      watch(t, out);
    }
    return out;
  }

 private:
  const test::RandomWind& own() const {
    static const test::RandomWind wind(1, 16.0, 0.8);
    return wind;
  }
  const test::RandomWind& others() const {
    static const test::RandomWind wind(77, 16.0, 0.8);
    return wind;
  }
};

// Lidar and rotor agree: everything is what it must be, to the accuracy of a box without noise.
TEST(MonitorTest, Agreement) {
  Box box;
  const Monitor::Outputs out = box.fly(400.0);
  EXPECT_EQ(out.reason, MonitorReason::Agree);
  EXPECT_EQ(out.authority, 1.0);
  EXPECT_EQ(out.trim_s, 0.0);
  EXPECT_GT(out.coherence, 0.98);
  EXPECT_NEAR(out.gain, 1.0, 0.03);
  EXPECT_NEAR(out.delay_s, kLead_s - 0.5 * kWindow_s, 0.1);
  EXPECT_NEAR(out.late_s, 0.0, 0.15);
  EXPECT_NEAR(out.mean_ratio, 1.0, 0.005);
}

// Without a feedforward beside it the lidar itself is what the gain is of.
TEST(MonitorTest, WithoutFeedforward) {
  Box box;
  box.feedforward = false;
  box.lead_error_s = 1.0;
  const Monitor::Outputs out = box.fly(400.0);
  EXPECT_NEAR(out.delay_s, kLead_s - 0.5 * kWindow_s + 1.0, 0.1);
  EXPECT_NEAR(out.late_s, -1.0, 0.1);
  EXPECT_GT(out.gain, 0.9);
  EXPECT_EQ(out.authority, 1.0);
}

// A lidar that sees another wind has no say.
TEST(MonitorTest, AnotherWind) {
  Box box;
  box.common = 0.0;
  box.noise_mps = 1.0;
  const Monitor::Outputs out = box.fly(600.0);
  EXPECT_LT(out.coherence, 0.35);
  EXPECT_LT(out.authority, 0.1);
  EXPECT_NE(out.reason, MonitorReason::Agree);
}

// Twice as much movement as there is: the slope says half, and half is break-even.
TEST(MonitorTest, LidarThatExaggerates) {
  Box box;
  box.common = 2.0;
  const Monitor::Outputs out = box.fly(400.0);
  EXPECT_NEAR(out.gain, 0.5, 0.02);
  EXPECT_NEAR(out.authority, 0.5, 0.08);
  EXPECT_EQ(out.reason, MonitorReason::WrongGain);
}

// The means differ by a third: none.
TEST(MonitorTest, BiasedLidar) {
  for (const double bias : {0.7, 1.4}) {
    Box box;
    box.bias = bias;
    const Monitor::Outputs out = box.fly(400.0);
    EXPECT_NEAR(out.mean_ratio, 1.0 / bias, 0.005);
    EXPECT_EQ(out.reason, MonitorReason::WrongMean);
    EXPECT_LT(out.authority, 0.01);
  }
}

// A feedforward that acts too late by more than twice the tolerance has none, whether the lead or
// the buffer is wrong; half of the tolerance costs nothing.
TEST(MonitorTest, WrongTime) {
  for (const bool buffer : {false, true}) {
    Box box;
    (buffer ? box.acts_late_s : box.lead_error_s) = buffer ? 4.5 : -4.5;
    Monitor::Outputs out = box.fly(400.0);
    EXPECT_NEAR(out.late_s, 4.5, 0.5) << buffer;
    EXPECT_LT(out.authority, 0.01);
    (buffer ? box.acts_late_s : box.lead_error_s) = buffer ? 1.0 : -1.0;
    out = box.fly(400.0);
    EXPECT_EQ(out.authority, 1.0) << buffer;
  }
}

// A feedforward of second order whose buffer makes up for its filter is in time; taken for one of
// first order it seems 2.5 s early.
TEST(MonitorTest, FilterOfSecondOrder) {
  const double w = radps_from_hz(0.08), wc = radps_from_hz(0.05);
  const double second_s = std::atan2(2.0 * 0.6 * w * wc, wc * wc - w * w) / w;
  const double first_s = std::atan(w / wc) / w;
  for (const int order : {1, 2}) {
    Box box;
    box.params.filter_order = order;
    box.params.filter_damping = 0.6;
    const Monitor monitor(box.params, kStep_s);
    Monitor::State state = monitor.initial_state();
    Monitor::Outputs out;
    for (int n = 0; n < 8000; ++n) {
      Monitor::Inputs in = box.inputs(n * kStep_s);
      in.cutoff_hz = 0.05;
      in.buffer_time_s -= second_s;
      out = monitor.step(in, state);
    }
    EXPECT_NEAR(out.late_s, order == 2 ? 0.0 : first_s - second_s, 0.15);
  }
}

// Asked to, the monitor trims the buffer, slowly, and no farther than it may.
TEST(MonitorTest, TrimsTheBuffer) {
  for (const DelayMethod method : {DelayMethod::Correlation, DelayMethod::Moddemeijer}) {
    Box box;
    box.params.delay_method = method;
    box.params.maximum_trim_s = 1.5;
    box.noise_mps = 0.2;
    box.acts_late_s = 1.0;
    const Monitor::Outputs out = box.fly(900.0);
    EXPECT_NEAR(out.trim_s, -1.0, 0.15);
    EXPECT_NEAR(out.late_s, 0.0, 0.15);
    box.trim_s = 0.0;
    box.params.maximum_trim_s = 0.4;
    EXPECT_NEAR(box.fly(900.0).trim_s, -0.4, 0.01);
  }
}

// No judgement before the learning time, and then no jump: the authority moves at its rate.
TEST(MonitorTest, LearnsFirstThenMovesSlowly) {
  Box box;
  box.bias = 1.5;
  box.params.authority.unknown = 0.8;
  const Monitor monitor(box.params, kStep_s);
  Monitor::State state = monitor.initial_state();
  double before = 0.8;
  for (int n = 0; n < 2000; ++n) {
    const Monitor::Outputs out = monitor.step(box.inputs(n * kStep_s), state);
    if (n * kStep_s < box.params.learning_s) {
      ASSERT_EQ(out.authority, 0.8);
      ASSERT_NE(out.reason, MonitorReason::WrongMean);
    }
    ASSERT_LE(std::abs(out.authority - before), 0.2 / 10.0 + 1e-12);
    before = out.authority;
  }
  EXPECT_EQ(before, 0.0);
}

// Lost data: authority goes while they are away and comes back, and no product spans the gap.
TEST(MonitorTest, LidarGoesAndComesBack) {
  Box box;
  const Monitor::Outputs out = box.fly(
      12000 * kStep_s,
      [](double t, Monitor::Inputs& in) {
        if (t <= 300.0 || t >= 320.0) return;
        in.lidar_valid = false;
        in.lidar_mps = std::nan("");
        in.buffered_mps = std::nan("");
      },
      [](double t, const Monitor::Outputs& then) {
        if (std::abs(t - 319.0) >= 1e-9) return;
        EXPECT_EQ(then.authority, 0.0);
        EXPECT_EQ(then.reason, MonitorReason::NoLidar);
      });
  EXPECT_EQ(out.authority, 1.0);
  EXPECT_GT(out.coherence, 0.95);
  EXPECT_NEAR(out.gain, 1.0, 0.05);
}

// What was measured outlasts a gap: a feedforward at the wrong time has no authority after it.
TEST(MonitorTest, WrongTimeOutlastsAGap) {
  Box box;
  box.acts_late_s = 4.5;
  double largest_after = 0.0;
  box.fly(
      440.0,
      [](double t, Monitor::Inputs& in) {
        if (t < 400.0 || t >= 401.0) return;
        in.lidar_valid = false;
        in.lidar_mps = in.buffered_mps = std::nan("");
      },
      [&](double t, const Monitor::Outputs& out) {
        if (t > 399.0) largest_after = std::max(largest_after, out.authority);
      });
  EXPECT_LT(largest_after, 0.05);
}

// Rubbish for a while (not a number, infinite) leaves no trace; without a turbine the last
// judgement stands.
TEST(MonitorTest, SurvivesRubbish) {
  Box box;
  const Monitor monitor(box.params, kStep_s);
  Monitor::State state = monitor.initial_state();
  Monitor::Outputs out;
  for (int n = 0; n < 8000; ++n) {
    const double t = n * kStep_s, bad = n % 2 == 0 ? std::nan("") : HUGE_VAL;
    Monitor::Inputs in = box.inputs(t);
    if (t > 200.0 && t < 203.0) in.lidar_mps = in.lead_s = bad;
    if (t > 210.0 && t < 213.0) in.buffered_mps = in.cutoff_hz = in.window_s = bad;
    if (t > 220.0 && t < 223.0) in.turbine.pitch_rad = bad;
    out = monitor.step(in, state);
    ASSERT_TRUE(out.authority >= 0.0 && out.authority <= 1.0);
    ASSERT_TRUE(std::isfinite(out.trim_s));
  }
  EXPECT_EQ(out.authority, 1.0);
  EXPECT_NEAR(out.gain, 1.0, 0.05);
}

// Each opinion alone: off, half, on; not a number does not count.
TEST(AuthorityTest, LeastOfTheOpinions) {
  const AuthorityParams p;
  const auto target = [&](auto&& change) {
    Evidence e{true, true, true, 1.0, 1.0, 0.0, 1.0};
    change(e);
    const Authority authority(p);
    Authority::State s = authority.initial_state();
    authority.step(e, 1000.0, s);
    EXPECT_EQ(s.value, s.target);
    return s;
  };
  EXPECT_EQ(target([](Evidence&) {}).value, 1.0);
  EXPECT_EQ(target([](Evidence& e) { e.late_s = e.gain = std::nan(""); }).value, 1.0);
  EXPECT_NEAR(target([](Evidence& e) { e.coherence = 0.25; }).value, 0.5, 1e-12);
  EXPECT_EQ(target([](Evidence& e) { e.gain = -1.0; }).reason, MonitorReason::WrongGain);
  EXPECT_EQ(target([](Evidence& e) { e.late_s = -4.0; }).value, 0.0);
  EXPECT_NEAR(target([](Evidence& e) { e.late_s = 3.0; }).value, 0.5, 1e-12);
  EXPECT_NEAR(target([](Evidence& e) { e.mean_ratio = std::exp(-0.225); }).value, 0.5, 1e-9);
  EXPECT_EQ(target([](Evidence& e) { e.lidar_valid = false; }).reason, MonitorReason::NoLidar);
  EXPECT_EQ(target([](Evidence& e) { e.learned = false; }).reason, MonitorReason::Learning);
  const auto blind = target([](Evidence& e) { e.learned = e.turbine_valid = false; });
  EXPECT_EQ(blind.reason, MonitorReason::NoTurbine);
  EXPECT_EQ(blind.value, 1.0);
  const auto two = target([](Evidence& e) { e.coherence = 0.3, e.gain = 0.35; });
  EXPECT_EQ(two.reason, MonitorReason::WrongGain);
}

// Small movements of the evidence are not followed, full and none always.
TEST(AuthorityTest, Hysteresis) {
  const Authority authority({});
  Authority::State s = authority.initial_state();
  Evidence e{true, true, true, 0.25, 1.0, 0.0, 1.0};
  authority.step(e, 1000.0, s);
  e.coherence = 0.265;
  authority.step(e, 1000.0, s);
  EXPECT_NEAR(s.value, 0.5, 1e-12);
  e.coherence = 0.29;
  authority.step(e, 1000.0, s);
  EXPECT_NEAR(s.value, 0.7, 1e-12);
  e.coherence = 0.34;
  authority.step(e, 1000.0, s);
  e.coherence = 0.36;
  authority.step(e, 1000.0, s);
  EXPECT_EQ(s.value, 1.0);
}

// The shipped file holds every key; mistakes are told with file, line and key.
TEST(MonitorParamsTest, RefusesMistakes) {
  const MonitorParams p = shipped();
  EXPECT_EQ(p.band_hz.size(), 3U);
  const std::string good = "\"" LAC_SOURCE_DIR
                           "/config/turbines/nrel5mw/cp_ct.txt\" ! RotorTable -\n63 ! RotorRadius "
                           "-\n4e7 ! InertiaLowSpeedShaft -\n97 ! GearboxRatio -\n";
  const auto error = [&](const std::string& line, double step_s = 0.0125) {
    return test::error_text([&] {
      InputFile in = InputFile::parse(good + line + "\n", "m.IN");
      MonitorParams::read(in).check_time_step(in, step_s);
    });
  };
  EXPECT_EQ(error(""), "no error");
  EXPECT_THAT(error("1 ! NoSuchKey -"), HasSubstr("m.IN:5: NoSuchKey"));
  EXPECT_THAT(error("0.4 ! CoherenceOff -"), HasSubstr("m.IN:5: CoherenceOff"));
  EXPECT_THAT(error("0.2 ! GainOn -"), HasSubstr("m.IN:5: GainOn"));
  EXPECT_THAT(error("0.02 0.01 ! BandFrequencies -"), HasSubstr("do not rise"));
  EXPECT_THAT(error("phase ! DelayMethod -"), HasSubstr("m.IN:5: DelayMethod"));
  EXPECT_THAT(error("0.05 ! UpdateInterval -", 0.1), HasSubstr("m.IN:5: UpdateInterval"));
  EXPECT_THAT(error("0.02 0.49 ! BandFrequencies -\n1.0 ! UpdateInterval -"),
              HasSubstr("m.IN:5: BandFrequencies"));
  EXPECT_THAT(error("-1 ! MaximumTrim -"), HasSubstr("m.IN:5: MaximumTrim"));
  EXPECT_THAT(error("3 ! FilterOrder -"), HasSubstr("m.IN:5: FilterOrder"));
}

}  // namespace
}  // namespace lac
