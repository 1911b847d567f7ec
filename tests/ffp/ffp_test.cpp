// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"

namespace lac {
namespace {

constexpr double kStep_s = 0.0125;

/// Straight pitch curve of 0.01 rad per m/s, so that rates can be told by hand.
FfpParams plain() {
  FfpParams p;
  p.cutoff_hz = LookupTable({10.0, 20.0}, {1.0 / (2.0 * kPi * 1.4), 1.0 / (2.0 * kPi * 1.4)});
  p.delay_frequency_hz = 0.0;
  p.actuator_frequency_hz = 2.0 * 0.7 / 0.4 / (2.0 * kPi);  // delay 0.4 s
  p.actuator_damping = 0.7;
  p.buffer_time_constant_s = 0.0;
  p.static_pitch_rad = LookupTable({0.0, 100.0}, {0.0, 1.0});
  p.threshold_mps = 5.0;
  p.fade_time_s = 1.0;
  return p;
}

Ffp::Inputs wind(double rews_mps, double lead_s = 4.0) {
  return {rews_mps, true, lead_s, 1.0, 16.0};
}

// Lecture: 100 m ahead at 25 m/s, filter 1.4 s, actuator 0.4 s, window 1 s: buffer 1.7 s.
TEST(Ffp, BufferTimeOfTheLectureExercise) {
  const Ffp ffp(plain(), kStep_s);
  Ffp::State s = ffp.initial_state();
  const auto out = ffp.step(wind(16.0, 100.0 / 25.0), s);
  EXPECT_NEAR(out.buffer_time_s, 1.7, 1e-12);
}

// HM eq. 26 and the actuator's phase delay, with their limits at low frequency.
TEST(Ffp, DelaysAgainstTheirTransferFunctions) {
  EXPECT_NEAR(filter_delay_s(0.5 / (2.0 * kPi), 0.0), 2.0, 1e-12);
  EXPECT_NEAR(filter_delay_s(0.05, 0.05), 0.125 / 0.05, 1e-12);  // 45 deg at the cut-off
  EXPECT_NEAR(actuator_delay_s(1.0, 0.7, 0.0), 1.4 / (2.0 * kPi), 1e-12);
  EXPECT_NEAR(actuator_delay_s(1.0, 0.7, 1.0), 0.25, 1e-12);  // 90 deg at its own frequency
  EXPECT_NEAR(actuator_delay_s(1.0, 0.7, 0.04), 0.2228, 2e-4);
  EXPECT_EQ(actuator_delay_s(0.0, 0.7, 0.04), 0.0);
}

// A sine comes out with the gain of the low-pass, delayed by filter and buffer: analytic.
TEST(Ffp, SineHasTheGainAndDelayOfFilterAndBuffer) {
  FfpParams p = plain();
  const double fc = 0.05, f = 0.03;
  p.cutoff_hz = LookupTable({16.0}, {fc});
  p.delay_frequency_hz = f;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  const double lead_s = 8.0, w = 2.0 * kPi * f;
  const double gain = 1.0 / std::sqrt(1.0 + f * f / (fc * fc));
  double worst = 0.0;
  for (int i = 0; i < 16000; ++i) {
    const double t = i * kStep_s;
    const auto out = ffp.step(wind(16.0 + std::sin(w * t), lead_s), s);
    if (t < 100.0) continue;
    // All delays but actuator and half the window are made up for: u(t) acts at t + lead.
    const double total_s = lead_s - actuator_delay_s(p.actuator_frequency_hz, 0.7, f) - 0.5;
    worst = std::max(worst, std::abs(out.buffered_mps - 16.0 - gain * std::sin(w * (t - total_s))));
  }
  EXPECT_LT(worst, 1e-5);
}

// The rate integrates to the static pitch of the wind, here over a ramp of 2 m/s.
TEST(Ffp, RateIntegratesToThePitchCurve) {
  const Ffp ffp(plain(), kStep_s);
  Ffp::State s = ffp.initial_state();
  double pitch_rad = 0.0;
  for (int i = 0; i < 8000; ++i) {
    const double t = i * kStep_s;
    const double u = 16.0 + std::clamp(0.2 * (t - 20.0), 0.0, 2.0);
    const auto out = ffp.step(wind(u), s);
    pitch_rad += out.rate_radps * kStep_s;
  }
  EXPECT_NEAR(pitch_rad, 0.02, 1e-9);
}

// Invalid wind: off with its reason, the rate fades without a step, and the filter starts anew.
TEST(Ffp, LosingTheWindFadesOutAndStartsAnew) {
  const Ffp ffp(plain(), kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  for (int i = 0; i < 1600; ++i) out = ffp.step(wind(16.0 + 0.2 * i * kStep_s), s);
  ASSERT_EQ(out.active, 1.0);
  const double rate = out.rate_radps;
  ASSERT_GT(rate, 0.001);
  Ffp::Inputs none;
  double last = rate;
  for (int i = 0; i < 81; ++i) {
    out = ffp.step(none, s);
    EXPECT_EQ(out.reason, FfpReason::NoWind);
    EXPECT_LE(std::abs(out.rate_radps - last), rate * kStep_s / 0.5 * 1.01);
    last = out.rate_radps;
  }
  EXPECT_EQ(out.rate_radps, 0.0);
  out = ffp.step(wind(25.0), s);
  EXPECT_EQ(out.reason, FfpReason::Filling);
  EXPECT_EQ(out.filtered_mps, 25.0);
}

// Beyond the ends of the pitch curve there is nothing to go by: off, and it says so.
TEST(Ffp, OutsideThePitchCurveIsOff) {
  FfpParams p = plain();
  p.static_pitch_rad = LookupTable({10.0, 20.0}, {0.0, 0.1});
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  for (int i = 0; i < 1600; ++i) out = ffp.step(wind(19.0), s);
  EXPECT_EQ(out.reason, FfpReason::None);
  for (int i = 0; i < 1600; ++i) out = ffp.step(wind(21.0), s);
  EXPECT_EQ(out.reason, FfpReason::OutsideCurve);
  EXPECT_EQ(out.active, 0.0);
}

// What the low-pass starts from is not wind to act on: it settles first.
TEST(Ffp, LowPassSettlesBeforeItIsUsed) {
  const Ffp ffp(plain(), kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  int filling = 0;
  for (int i = 0; i < 1600; ++i) {
    out = ffp.step(wind(16.0), s);
    filling += out.reason == FfpReason::Filling ? 1 : 0;
  }
  EXPECT_NEAR(filling * kStep_s, 1.7 + 2.0 * 1.4, 2.0 * kStep_s);  // buffer + two time constants
  EXPECT_EQ(out.reason, FfpReason::None);
}

// Another gate shifts the wind in time at once; the buffer goes along and no rate comes of it.
TEST(Ffp, ChangeOfGateMovesTheBufferAtOnce) {
  FfpParams p = plain();
  p.buffer_time_constant_s = 10.0;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  const auto u = [](double arrival_s) { return 16.0 + 0.05 * arrival_s; };
  double worst = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double t = i * kStep_s, lead_s = t < 30.0 ? 4.0 : 4.8;
    const auto out = ffp.step(wind(u(t + lead_s), lead_s), s);
    if (t > 30.0) {
      EXPECT_NEAR(out.buffer_time_s, lead_s - 2.3, 1e-9);
    }
    if (t > 20.0) worst = std::max(worst, std::abs(out.rate_radps - 0.0005));
  }
  EXPECT_LT(worst, 0.0005 * 1.01);
}

// A lead that is short once needs something to spare before it counts again.
TEST(Ffp, LeadTooShortHasHysteresis) {
  const Ffp ffp(plain(), kStep_s);
  Ffp::State s = ffp.initial_state();
  EXPECT_EQ(ffp.step(wind(16.0, 2.29), s).reason, FfpReason::LeadTooShort);
  EXPECT_EQ(ffp.step(wind(16.0, 2.35), s).reason, FfpReason::LeadTooShort);
  EXPECT_EQ(ffp.step(wind(16.0, 2.45), s).reason, FfpReason::Filling);
}

// An error value of other chains never reaches filter or buffer.
TEST(Ffp, NotANumberNeverEntersTheFilter) {
  const Ffp ffp(plain(), kStep_s);
  Ffp::State s = ffp.initial_state();
  for (int i = 0; i < 800; ++i) {
    const auto out = ffp.step(wind(i == 400 ? std::nan("") : 16.0), s);
    ASSERT_TRUE(std::isfinite(out.rate_radps));
    if (i > 400) {
      ASSERT_EQ(out.filtered_mps, 16.0);
    }
  }
}

// Too short a lead switches off and says so; nothing is clipped to zero delay.
TEST(Ffp, LeadTooShortIsOff) {
  const Ffp ffp(plain(), kStep_s);
  Ffp::State s = ffp.initial_state();
  const auto out = ffp.step(wind(16.0, 2.2), s);  // 2.2 - 1.4 - 0.4 - 0.5 < 0
  EXPECT_EQ(out.reason, FfpReason::LeadTooShort);
  EXPECT_EQ(out.active, 0.0);
}

// A buffer beyond the memory is refused, not shortened.
TEST(Ffp, BufferBeyondMemoryIsOff) {
  FfpParams p = plain();
  p.longest_buffer_s = 5.0;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  for (int i = 0; i < 2000; ++i) out = ffp.step(wind(16.0, 20.0), s);
  EXPECT_EQ(out.reason, FfpReason::BufferTooLong);
}

// Below the threshold it is off; it comes on above and stays on within the hysteresis.
TEST(Ffp, ThresholdHasHysteresisAndFades) {
  FfpParams p = plain();
  p.threshold_mps = 14.0;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  const auto settle = [&](double u) {
    Ffp::Outputs out;
    for (int i = 0; i < 1600; ++i) out = ffp.step(wind(u), s);
    return out;
  };
  EXPECT_EQ(settle(13.8).reason, FfpReason::BelowThreshold);
  EXPECT_EQ(settle(14.2).active, 1.0);
  EXPECT_EQ(settle(13.8).active, 1.0);
  EXPECT_EQ(settle(13.4).active, 0.0);
}

// A rate beyond MaximumRate is cut and the reason says so.
TEST(Ffp, RateLimitIsTold) {
  FfpParams p = plain();
  p.max_rate_radps = 0.001;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  for (int i = 0; i < 1600; ++i) out = ffp.step(wind(16.0 + 1.0 * i * kStep_s), s);
  EXPECT_EQ(out.reason, FfpReason::RateLimited);
  EXPECT_EQ(out.rate_radps, 0.001);
}

// A new mean wind speed moves the buffer slowly: the pitch rate it causes stays small.
TEST(Ffp, NewMeanSpeedIsBumpless) {
  FfpParams p = plain();
  p.buffer_time_constant_s = 10.0;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  double worst = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double t = i * kStep_s;
    Ffp::Inputs in = wind(16.0 + 0.05 * t, t < 30.0 ? 4.0 : 4.15);
    const auto out = ffp.step(in, s);
    if (t > 20.0) worst = std::max(worst, std::abs(out.rate_radps - 0.0005));
  }
  EXPECT_LT(worst, 0.0005 * 0.0155);  // 0.15 s over 10 s: 1.5 % of the ramp's own rate
}

// Half the authority is half the rate; what the monitor takes away leaves without a step.
TEST(Ffp, MonitorTakesItsShareOfTheRate) {
  FfpParams p = plain();
  p.use_monitor = true;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  double last = 0.0;
  Ffp::Outputs out;
  int i = 0;
  const auto fly = [&](int steps, double authority) {
    for (const int end = i + steps; i < end; ++i) {
      Ffp::Inputs in = wind(16.0 + 0.02 * i * kStep_s);
      in.monitor_authority = authority;
      out = ffp.step(in, s);
      if (i > 800) {
        EXPECT_LE(std::abs(out.rate_radps - last), 0.0002 * kStep_s / 0.5 * 1.01);
      }
      last = out.rate_radps;
    }
  };
  fly(1600, 1.0);
  EXPECT_NEAR(out.rate_radps, 0.0002, 1e-9);
  EXPECT_EQ(out.reason, FfpReason::None);
  fly(100, 0.5);
  EXPECT_NEAR(out.rate_radps, 0.0001, 1e-9);
  EXPECT_EQ(out.reason, FfpReason::AuthorityReduced);
  EXPECT_EQ(out.active, 1.0);
  for (const double wrong : {std::nan(""), -0.1, 1.1}) {
    fly(100, 1.0);
    EXPECT_NEAR(out.rate_radps, 0.0002, 1e-9);
    fly(100, wrong);
    EXPECT_EQ(out.rate_radps, 0.0) << wrong;
    EXPECT_EQ(out.reason, FfpReason::MonitorInvalid);
  }
}

// A trim of the monitor arrives with the lag of the buffer and no faster; without the key no
// monitor is heard.
TEST(Ffp, MonitorTrimsTheBufferSlowly) {
  FfpParams p = plain();
  p.buffer_time_constant_s = 10.0;
  for (const bool use : {true, false}) {
    p.use_monitor = use;
    const Ffp ffp(p, kStep_s);
    Ffp::State s = ffp.initial_state();
    double worst = 0.0;
    Ffp::Outputs out;
    for (int i = 0; i < 8000; ++i) {
      const double t = i * kStep_s;
      Ffp::Inputs in = wind(16.0 + 0.05 * t);
      in.monitor_trim_s = t < 30.0 ? 0.0 : 0.5;
      if (!use) in.monitor_authority = std::nan("");
      out = ffp.step(in, s);
      if (t > 20.0) worst = std::max(worst, std::abs(out.rate_radps - 0.0005));
    }
    EXPECT_NEAR(out.buffer_time_s, use ? 2.2 : 1.7, 1e-3);
    EXPECT_NEAR(out.lead_needed_s, use ? 1.8 : 2.3, 1e-12);
    EXPECT_LT(worst, 0.0005 * 0.0505);  // 0.5 s over 10 s: 5 % of the ramp's own rate
    EXPECT_EQ(out.reason, FfpReason::None);
  }
}

// A saved state continues to the last bit.
TEST(Ffp, SavedStateContinuesExactly) {
  const Ffp ffp(plain(), kStep_s);
  Ffp::State a = ffp.initial_state(), b = ffp.initial_state();
  const auto u = [](int i) { return 16.0 + std::sin(0.01 * i); };
  for (int i = 0; i < 1000; ++i) ffp.step(wind(u(i)), a);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  a.visit(save);
  StateArchive load{std::span<const std::byte>(bytes)};
  b.visit(load);
  ASSERT_TRUE(load.complete());
  for (int i = 1000; i < 2000; ++i) {
    ASSERT_EQ(ffp.step(wind(u(i)), a).rate_radps, ffp.step(wind(u(i)), b).rate_radps);
  }
}

}  // namespace
}  // namespace lac
