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

// The limit is for what is sent: a weight of one half leaves room for twice the rate of the curve.
TEST(Ffp, RateLimitIsForTheWeightedRate) {
  FfpParams p = plain();
  p.entry = EntryRule::Slope;
  p.largest_slope_radpmps = 0.005;  // of 0.01
  p.max_rate_radps = 0.006;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  for (int i = 0; i < 1600; ++i) out = ffp.step(wind(16.0 + 1.0 * i * kStep_s), s);
  EXPECT_EQ(out.reason, FfpReason::None);
  EXPECT_NEAR(out.rate_radps, 0.005, 1e-6);
}

// With `slope` the curve whose slope is cut is that of the power level.
TEST(Ffp, EntryBySlopeOfTheReducedCurve) {
  FfpParams p = plain();
  p.static_pitch_rad = LookupTable({0.0, 12.0, 30.0}, {0.0, 0.0, 0.18});
  p.reduced_pitch_rad = LookupTable({0.0, 9.0, 30.0}, {0.0, 0.0, 0.21});
  p.reduced_power_level = 0.5;
  p.entry = EntryRule::Slope;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  for (int i = 0; i < 1600; ++i) {
    Ffp::Inputs in = wind(10.0 + 0.05 * i * kStep_s);  // below rated: the reduced curve alone rises
    in.power_level = 0.5;
    out = ffp.step(in, s);
  }
  EXPECT_EQ(out.reason, FfpReason::None);
  EXPECT_NEAR(out.rate_radps, 0.0005, 1e-6);
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

// A mean wind that rises from 12 to 24 m/s in five minutes moves cut-off, lead and buffer, none of
// which is pitch activity of its own: steady wind keeps a rate of zero, and in a ramp the rate
// stays at the static one, but for what the moving delay adds, 1 - dT/dt.
TEST(Ffp, RampOfTheMeanWindMakesNoPitchRate) {
  for (const int order : {1, 2}) {
    FfpParams p = plain();
    p.cutoff_hz = LookupTable({12.0, 24.0}, {0.04, 0.08});
    p.filter_order = order;
    p.damping = LookupTable({12.0, 24.0}, {0.8, 0.7});
    p.delay_frequency_hz = 0.08;
    p.buffer_time_constant_s = 10.0;
    p.buffer_trim_s = LookupTable({12.0, 24.0}, {-0.6, -0.3});
    for (const double slope : {0.0, 0.02}) {
      const Ffp ffp(p, kStep_s);
      Ffp::State s = ffp.initial_state();
      double worst = 0.0;
      for (int i = 0; i < 32000; ++i) {
        const double t = i * kStep_s;
        Ffp::Inputs in = wind(16.0 + slope * t);
        in.mean_speed_mps = 12.0 + std::clamp((t - 60.0) / 25.0, 0.0, 12.0);
        in.lead_s = 120.0 / in.mean_speed_mps;
        const auto out = ffp.step(in, s);
        if (t > 30.0) worst = std::max(worst, std::abs(out.rate_radps - 0.01 * slope));
      }
      if (slope == 0.0) {
        EXPECT_LT(worst, 1e-12) << order;
      } else {  // 4.6 s of delay become 2.9 s in 300 s, faster at the beginning
        EXPECT_LT(worst, 0.05 * 0.01 * slope) << order;
      }
    }
  }
}

// Second order: gain and delay of w0^2/(s^2 + 2 z w0 s + w0^2), the delay made up for by the
// buffer.
TEST(Ffp, SecondOrderHasItsGainAndDelay) {
  FfpParams p = plain();
  const double f0 = 0.06, z = 0.8, f = 0.04, w = 2.0 * kPi * f;
  p.filter_order = 2;
  p.cutoff_hz = LookupTable({16.0}, {f0});
  p.damping = LookupTable({16.0}, {z});
  p.delay_frequency_hz = f;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  const double lead_s = 8.0, r = f / f0;
  const double gain = 1.0 / std::hypot(1.0 - r * r, 2.0 * z * r);
  const double total_s = lead_s - actuator_delay_s(p.actuator_frequency_hz, 0.7, f) - 0.5;
  double worst = 0.0;
  for (int i = 0; i < 16000; ++i) {
    const double t = i * kStep_s;
    const auto out = ffp.step(wind(16.0 + std::sin(w * t), lead_s), s);
    if (t > 100.0)
      worst =
          std::max(worst, std::abs(out.buffered_mps - 16.0 - gain * std::sin(w * (t - total_s))));
  }
  EXPECT_LT(worst, 2e-5);
}

// The cut-off follows the turbulence intensity slowly; one that is not known changes nothing.
TEST(Ffp, TurbulenceMovesTheCutoff) {
  FfpParams p = plain();
  p.cutoff_hz = LookupTable({16.0}, {0.05});
  p.turbulence_factor = LookupTable({0.1, 0.2}, {0.8, 1.2});
  p.buffer_time_constant_s = 10.0;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  const auto fly = [&](int steps, double intensity) {
    for (int i = 0; i < steps; ++i) {
      Ffp::Inputs in = wind(16.0, 6.0);
      in.turbulence_intensity = intensity;
      const double before = out.cutoff_hz;
      out = ffp.step(in, s);
      if (before > 0.0) {
        EXPECT_LE(std::abs(out.cutoff_hz - before), 2.0e-3 * 0.05);  // not 0.2 of it at once
      }
    }
  };
  fly(100, std::nan(""));
  EXPECT_EQ(out.cutoff_hz, 0.05);
  fly(8000, 0.2);
  EXPECT_NEAR(out.cutoff_hz, 0.06, 1e-4);
  fly(8000, std::nan(""));
  EXPECT_NEAR(out.cutoff_hz, 0.05, 1e-4);
}

// A buffer tuned by hand is what it is, whatever the lead, and asks for none.
TEST(Ffp, FixedBufferIgnoresTheLead) {
  FfpParams p = plain();
  p.fixed_buffer_s = 1.5;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  for (int i = 0; i < 800; ++i) {
    const auto out = ffp.step(wind(16.0, i < 400 ? 1.0 : 4.0), s);
    EXPECT_EQ(out.buffer_time_s, 1.5);
    EXPECT_EQ(out.lead_needed_s, 0.0);
  }
  EXPECT_EQ(s.active > 0.0, true);
}

// Blend and slope have no switch: the pitch they add depends on the wind alone, so that a gust that
// comes and goes leaves nothing behind, and its size is the integral of their weights.
TEST(Ffp, EntryByWeightLeavesNothingBehind) {
  FfpParams p = plain();
  p.static_pitch_rad = LookupTable({0.0, 10.0, 12.0, 30.0}, {0.0, 0.0, 0.1, 0.28});
  p.blend_from_mps = 12.0, p.blend_to_mps = 16.0;
  p.largest_slope_radpmps = 0.02;
  for (const EntryRule rule : {EntryRule::Blend, EntryRule::Slope}) {
    p.entry = rule;
    const Ffp ffp(p, kStep_s);
    Ffp::State s = ffp.initial_state();
    double pitch_rad = 0.0, largest_rad = 0.0, last = 0.0, kick = 0.0;
    for (int i = 0; i < 16000; ++i) {
      const double t = i * kStep_s;
      const auto out = ffp.step(wind(13.0 - 4.0 * std::cos(2.0 * kPi * (t - 20.0) / 80.0)), s);
      if (t > 20.0 && t <= 100.0 + 2.3) pitch_rad += out.rate_radps * kStep_s;
      largest_rad = std::max(largest_rad, pitch_rad);
      if (t > 20.0) kick = std::max(kick, std::abs(out.rate_radps - last));
      last = out.rate_radps;
    }
    // Blend: 0.01 rad/(m/s) times half of 4 m/s and all of 1 m/s; slope: 0.02 over 2 m/s, 0.01
    // over 5.
    EXPECT_NEAR(largest_rad, rule == EntryRule::Blend ? 0.03 : 0.09, 0.003);
    EXPECT_NEAR(pitch_rad, 0.0, 0.003);
    if (rule == EntryRule::Blend) {
      EXPECT_LT(kick, 1e-4);
    }
  }
}

// The pitch that is added stays within its limit; what the feedback takes over may be added again.
TEST(Ffp, LargestPitchLimitsWhatIsAdded) {
  FfpParams p = plain();
  p.largest_pitch_rad = 0.01;
  p.largest_pitch_time_s = 10.0;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  double kept_rad = 0.0;
  Ffp::Outputs out;
  for (int i = 0; i < 4000; ++i) {
    out = ffp.step(wind(16.0 + 0.5 * i * kStep_s), s);  // 0.005 rad/s, 0.05 rad without limit
    kept_rad += out.rate_radps * kStep_s - kept_rad * kStep_s / 10.0;
    EXPECT_LE(kept_rad, 0.01 + 1e-12);
  }
  EXPECT_EQ(out.reason, FfpReason::PitchLimited);
  EXPECT_NEAR(out.rate_radps, 0.001, 1e-9);  // what is forgotten
}

// At a power level between the two curves the rate is that of their mean; a change of the level
// alone is no pitch of the feedforward.
TEST(Ffp, PowerLevelMovesBetweenTwoCurves) {
  FfpParams p = plain();
  p.reduced_pitch_rad = LookupTable({0.0, 100.0}, {0.5, 2.5});
  p.reduced_power_level = 0.5;
  const Ffp ffp(p, kStep_s);
  Ffp::State s = ffp.initial_state();
  Ffp::Outputs out;
  const auto fly = [&](int from, int to, double level, double slope) {
    for (int i = from; i < to; ++i) {
      Ffp::Inputs in = wind(16.0 + slope * i * kStep_s);
      in.power_level = level;
      out = ffp.step(in, s);
    }
  };
  fly(0, 1600, 0.75, 0.1);
  EXPECT_NEAR(out.rate_radps, 0.1 * 0.015, 1e-8);
  fly(1600, 3200, std::nan(""), 0.1);
  EXPECT_NEAR(out.rate_radps, 0.1 * 0.01, 1e-9);
  fly(0, 4000, 1.0, 0.0);
  for (const double level : {0.9, 0.4, 1.1}) {
    fly(0, 10, level, 0.0);
    EXPECT_NEAR(out.rate_radps, 0.0, 1e-12);
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
