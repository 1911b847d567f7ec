// SPDX-License-Identifier: Apache-2.0
#include "ffp/guo_ffp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ffp/guo_ffp_legacy.hpp"
#include "support/error_text.hpp"
#include "support/guo_host.hpp"
#include "support/no_alloc_guard.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using test::GuoHost;
using test::TempFolder;
using ::testing::HasSubstr;

constexpr double kStep_s = 0.0125;
constexpr int kFadeSteps = 160;  // 2 s

GuoFfpParams params(const std::string& text) {
  return GuoFfpParams::read(GuoInputFile::parse(text, "f.IN"), kStep_s);
}

class Feedforward {
 public:
  explicit Feedforward(const std::string& text)
      : ffp_(params(text), kStep_s), state_(ffp_.initial_state()) {}
  Ffp::Outputs step(double rews_mps, bool valid = true) {
    return ffp_.step(rews_mps, valid, state_);
  }
  Ffp::Outputs hold(double rews_mps, int steps) {
    Ffp::Outputs out;
    for (int i = 0; i < steps; ++i) out = step(rews_mps);
    return out;
  }

 private:
  GuoFfp ffp_;
  GuoFfp::State state_;
};

class Legacy {
 public:
  explicit Legacy(const std::string& text)
      : ffp_(params(text), static_cast<float>(kStep_s)), state_(ffp_.initial_state()) {}
  Ffp::Outputs step(double rews_mps) { return ffp_.step(rews_mps, state_); }

 private:
  GuoFfpLegacy ffp_;
  GuoFfpLegacy::State state_;
};

/// Amplitude of the filtered wind for a sine of 1 m/s around 15 m/s, once settled.
double gain(const std::string& text, double frequency_radps) {
  Feedforward ffp(text);
  double highest = 0.0;
  const int settled = 20000,
            steps = settled + static_cast<int>(2.1 * 3.15 / frequency_radps / kStep_s);
  for (int i = 0; i < steps; ++i) {
    const double filtered = ffp.step(15.0 + std::sin(frequency_radps * i * kStep_s)).filtered_mps;
    if (i > settled) highest = std::max(highest, filtered - 15.0);
  }
  return highest;
}

// T_buffer is kept to the step: 2.9/0.0125 is 231.99999999999997 in floating point, and 232.
TEST(GuoFfp, DelayIsExact) {
  Feedforward ffp(test::guo_ffp_v1(0, 1.0, 2.9));
  ffp.hold(12.0, 500);
  EXPECT_EQ(ffp.hold(13.0, 232).buffered_mps, 12.0);
  EXPECT_EQ(ffp.step(13.0).buffered_mps, 13.0);
}

// Off until the buffer is full; then it comes on where it is, without a movement of its own.
TEST(GuoFfp, StartHasNoPulse) {
  Feedforward ffp(test::guo_ffp_v1(0, 1.0, 3.0));
  for (int i = 0; i < 240; ++i) {
    const Ffp::Outputs out = ffp.step(14.0);
    EXPECT_EQ(out.reason, FfpReason::Filling);
    EXPECT_EQ(out.rate_radps, 0.0);
    EXPECT_TRUE(std::isnan(out.buffered_mps));
  }
  for (int i = 1; i <= 2 * kFadeSteps; ++i) {
    const Ffp::Outputs out = ffp.step(14.0);
    EXPECT_EQ(out.reason, FfpReason::None);
    EXPECT_EQ(out.rate_radps, 0.0);
    EXPECT_NEAR(out.pitch_rad, 0.04, 1e-15);
    EXPECT_NEAR(out.active, std::min(1.0, i * kStep_s / 2.0), 1e-12);
  }
}

// A step of the staircase turns by the same angle as theirs, but no faster than the limit.
TEST(GuoFfp, RateLimitKeepsTheAngle) {
  Feedforward ffp(test::guo_ffp_v1(0, 1.0, 0.0));
  ffp.hold(12.0, 2 * kFadeSteps);
  double turned_rad = 0.0, fastest_radps = 0.0;
  for (int i = 0; i < 40; ++i) {
    const Ffp::Outputs out = ffp.step(13.0);
    EXPECT_EQ(out.reason, i < 11 ? FfpReason::RateLimited : FfpReason::None);  // 11.4 steps
    turned_rad += out.rate_radps * kStep_s;
    fastest_radps = std::max(fastest_radps, out.rate_radps);
  }
  EXPECT_NEAR(turned_rad, 0.01, 1e-12);
  EXPECT_NEAR(fastest_radps, 0.07, 1e-12);
}

// Lost wind: off at once; then all begins anew, filters included.
TEST(GuoFfp, LostWind) {
  Feedforward ffp(test::guo_ffp_v1(1, 0.5, 1.0));
  ffp.hold(14.0, 400);
  const Ffp::Outputs lost = ffp.step(25.0, false);
  EXPECT_EQ(lost.reason, FfpReason::NoWind);
  EXPECT_EQ(lost.active, 0.0);
  EXPECT_EQ(lost.rate_radps, 0.0);
  const Ffp::Outputs back = ffp.step(18.0);
  EXPECT_EQ(back.filtered_mps, 18.0);
  EXPECT_EQ(back.reason, FfpReason::Filling);
}

// The low-pass has its -3 dB at f_cutoff [rad/s].
TEST(GuoFfp, LowPass) {
  EXPECT_NEAR(gain(test::guo_ffp_v1(1, 0.8, 1.0), 0.8), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(gain(test::guo_ffp_v1(0, 0.8, 1.0), 0.8), 1.0, 1e-3);
}

// The notch of FFP_v2 runs: gain betaNum/betaDen at its centre, and as
// (w0^2 - w^2 + 2j w0 num w)/(w0^2 - w^2 + 2j w0 den w) beside it; FlagLPF is a flag of its own.
TEST(GuoFfp, Notch) {
  EXPECT_NEAR(gain(test::guo_ffp_v2(0, 1, 1.0), 0.9), 0.02 / 0.4, 1e-3);
  const double w = 0.6, w0 = 0.9, real = w0 * w0 - w * w;
  const double expected =
      std::hypot(real, 2.0 * w0 * 0.02 * w) / std::hypot(real, 2.0 * w0 * 0.4 * w);
  EXPECT_NEAR(gain(test::guo_ffp_v2(0, 1, 1.0), w), expected, 1e-3);
  EXPECT_NEAR(gain(test::guo_ffp_v2(0, 0, 1.0), 0.9), 1.0, 1e-3);
  EXPECT_NEAR(gain(test::guo_ffp_v2(1, 0, 1.0), 0.3), std::sqrt(0.5), 1e-3);
}

// Measured with their FFP_v1: at DT 0.0125 s and T_buffer 3 s a step of the REWS at call 100
// arrives at call 338, in a one-step pulse of 0.8 rad/s on a curve of 0.01 rad per m/s.
TEST(GuoFfpLegacy, DelayAndPulseAsMeasured) {
  Legacy ffp(test::guo_ffp_v1(0, 1.0, 3.0));
  for (int call = 0; call < 400; ++call) {
    const Ffp::Outputs out = ffp.step(call < 100 ? 12.0 : 13.0);
    EXPECT_EQ(out.buffered_mps, call < 338 ? 12.0 : 13.0) << call;
    EXPECT_NEAR(out.rate_radps, call == 338 ? 0.8 : 0.0, 1e-6) << call;
  }
}

// ... and a first wind of 12 m/s after a start at 0 a pulse of 1.6 rad/s.
TEST(GuoFfpLegacy, StartUpPulseAsMeasured) {
  Legacy ffp(test::guo_ffp_v1(0, 1.0, 3.0));
  double highest = 0.0;
  for (int call = 0; call < 400; ++call) {
    highest = std::max(highest, ffp.step(call < 10 ? 0.0 : 12.0).rate_radps);
  }
  EXPECT_NEAR(highest, 1.6, 1e-6);
}

// 999 passes the filter's input but not into the buffer; 2000 values are all it holds.
TEST(GuoFfpLegacy, ErrorValueAndLimits) {
  Legacy unfiltered(test::guo_ffp_v1(0, 1.0, 0.0));
  unfiltered.step(12.0);
  const Ffp::Outputs bad = unfiltered.step(999.0);
  EXPECT_EQ(bad.filtered_mps, 999.0);
  EXPECT_EQ(bad.buffered_mps, 12.0);
  EXPECT_EQ(Legacy(test::guo_ffp_v1(0, 1.0, 0.0)).step(12.0).buffer_time_s, 0.0);
  Legacy longest(test::guo_ffp_v1(0, 1.0, 40.0));
  EXPECT_NEAR(longest.step(12.0).buffer_time_s, 1999 * kStep_s, 1e-5);
}

// Their low-pass: bilinear without prewarping, rounded to single precision in each step.
TEST(GuoFfpLegacy, LowPass) {
  Legacy ffp(test::guo_ffp_v1(1, 0.2, 0.0));
  EXPECT_EQ(ffp.step(12.0).filtered_mps, 12.0);
  const double w = 0.2 * static_cast<double>(0.0125f);
  const double first = 12.0 + w / (2.0 + w);
  EXPECT_NEAR(ffp.step(13.0).filtered_mps, first, 5e-7);
  const double second = (first * (2.0 - w) + 2.0 * w * 13.0) / (2.0 + w);
  EXPECT_NEAR(ffp.step(13.0).filtered_mps, second, 1e-6);
}

// Their FFP_v2 reads FlagNotch into FlagLPF: the notch never runs, the flag switches the low-pass.
TEST(GuoFfpLegacy, V2FlagNotchSwitchesTheLowPass) {
  Legacy notch(test::guo_ffp_v2(0, 1, 0.0)), low_pass(test::guo_ffp_v2(1, 0, 0.0));
  Legacy v1(test::guo_ffp_v1(1, 0.3, 0.0));
  for (int i = 0; i < 50; ++i) {
    const double wind_mps = 12.0 + std::sin(0.4 * i);
    EXPECT_EQ(notch.step(wind_mps).filtered_mps, v1.step(wind_mps).filtered_mps);
    EXPECT_EQ(low_pass.step(wind_mps).filtered_mps, wind_mps);
  }
}

// A checkpoint holds the whole state, of both.
TEST(GuoFfp, StateIsComplete) {
  const auto check = [](auto& ffp, auto step) {
    auto a = ffp.initial_state(), b = ffp.initial_state();
    for (int i = 0; i < 300; ++i) step(a, i);
    std::vector<std::byte> bytes;
    StateArchive save(bytes);
    a.visit(save);
    StateArchive load{std::span<const std::byte>(bytes)};
    b.visit(load);
    ASSERT_TRUE(load.complete());
    for (int i = 300; i < 500; ++i) {
      const Ffp::Outputs x = step(a, i), y = step(b, i);
      EXPECT_EQ(x.rate_radps, y.rate_radps);
      EXPECT_EQ(x.buffered_mps, y.buffered_mps);
      EXPECT_EQ(x.active, y.active);
    }
  };
  const GuoFfpParams p = params(test::guo_ffp_v2(1, 1, 1.0));
  const auto wind_mps = [](int i) { return 15.0 + std::sin(0.1 * i); };
  const GuoFfp ours(p, kStep_s);
  check(ours, [&](GuoFfp::State& s, int i) { return ours.step(wind_mps(i), true, s); });
  const GuoFfpLegacy theirs(p, static_cast<float>(kStep_s));
  check(theirs, [&](GuoFfpLegacy::State& s, int i) { return theirs.step(wind_mps(i), s); });
}

// Errors come with file, line and key of their form; degrees are not taken for radians.
TEST(GuoFfpParams, Errors) {
  const auto error = [](std::string text, const std::string& what, const std::string& by) {
    text.replace(text.find(what), what.size(), by);
    return test::error_text([&] { params(text); });
  };
  const std::string v1 = test::guo_ffp_v1(1, 0.2, 3.0), v2 = test::guo_ffp_v2(1, 1, 3.0);
  EXPECT_EQ(error(v1, "0 0 0.2 !", "0 0 20 !"),
            "f.IN:11: StaticPitch: found 20, expected a number from -0.5 to 1.570796327");
  EXPECT_EQ(error(v1, "3 ! n_", "4 ! n_"),
            "f.IN:10: StaticWind: found 3 values, expected 4 as n_StaticPitchCurve says");
  EXPECT_THAT(error(v1, "0 10 30", "0 10 10"), HasSubstr("f.IN:10: StaticWind: value 3"));
  EXPECT_THAT(error(v1, "0.200000", "300"), HasSubstr("f.IN:5: f_cutoff: found 300 rad/s, expected "
                                                      "less than 251.3"));
  EXPECT_THAT(error(v1, "1 ! FlagLPF", "2 ! FlagLPF"), HasSubstr("f.IN:4: FlagLPF: found '2'"));
  EXPECT_THAT(error(v1, "3.000000", "-1"), HasSubstr("f.IN:6: T_buffer: found -1"));
  EXPECT_THAT(error(v1, "!------- STATIC PITCH CURVE\n", ""),
              HasSubstr("f.IN:9: found '0 10 30 ! StaticWind - [m/s]', expected 'value(s) ! "
                        "n_StaticPitchCurve', which stands in line 8; read as FFP_v1"));
  EXPECT_THAT(error(v2, "0.02 !", "0.5 !"), HasSubstr("f.IN:8: betaNum_Notch: found 0.5, expected "
                                                      "less than 0.4 (betaDen_Notch)"));
}

// In a foreign master: REWS of Guo's block in, three results out, 999 where there is none.
TEST(GuoFfpLibrary, ForeignMaster) {
  const TempFolder folder;
  GuoHost host("liblac_ffp", folder.write("f.IN", test::guo_ffp_v1(0, 1.0, 1.0)), 2);
  host.put_rews(0.0);  // nobody has written yet
  EXPECT_EQ(host.call(), 1);
  EXPECT_EQ(host.caller.message(),
            "ffp: input file read as FFP_v1 of Guo's chain; differences: docs/hosts/guo.md");
  for (const double nothing : {999.0, -15.7, 0.0}) {
    host.put_rews(nothing);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(host.call(), 0) << host.caller.message();
    EXPECT_EQ(host.result(guo_lidar::kRewsBuffered), 999.0);
    EXPECT_EQ(host.result(guo_lidar::kPitchRate), 0.0);
  }
  host.put_rews(14.0);
  for (int i = 0; i < 80; ++i) host.call();
  EXPECT_EQ(host.result(guo_lidar::kRewsBuffered), 999.0);
  EXPECT_EQ(host.result(guo_lidar::kRewsFiltered), 14.0);
  for (int i = 0; i < 2 * kFadeSteps; ++i) host.call();
  EXPECT_EQ(host.result(guo_lidar::kRewsBuffered), 14.0);
  host.put_rews(14.05);
  for (int i = 0; i < 80; ++i) host.call();
  host.call();
  EXPECT_NEAR(host.result(guo_lidar::kPitchRate), 0.0005 / 0.0125, 1e-5);
}

// Behind our master the REWS of our LDP counts, with its validity, and all records are written.
TEST(GuoFfpLibrary, BehindOurMaster) {
  const TempFolder folder;
  GuoHost host("liblac_ffp", folder.write("f.IN", test::guo_ffp_v1(1, 0.5, 1.0)), 1,
               kPrivateArraySize);
  SwapView swap = host.caller.swap();
  host.put_rews(25.0);
  swap.set(Rec::LidarRews, 16.0);
  swap.set(Rec::LidarRewsValid, 1.0);
  host.call();
  for (int i = 0; i < 400; ++i) ASSERT_EQ(host.call(), 0) << host.caller.message();
  EXPECT_EQ(swap.get(Rec::RewsBuffered), 16.0);
  EXPECT_NEAR(swap.get(Rec::FeedforwardPitch), 0.06, 1e-7);
  EXPECT_EQ(swap.get(Rec::FeedforwardActive), 1.0);
  EXPECT_EQ(swap.get(Rec::FeedforwardReason), 0.0);
  EXPECT_EQ(swap.get(Rec::FeedforwardBufferTime), 1.0);
  EXPECT_NEAR(swap.get(Rec::FeedforwardCutOff), 0.5 / (2.0 * 3.14159265), 1e-7);
  EXPECT_EQ(swap.get(Rec::FeedforwardLeadNeeded), 0.0);
  EXPECT_EQ(host.result(guo_lidar::kRewsBuffered), 16.0);
  swap.set(Rec::LidarRewsValid, 0.0);
  EXPECT_EQ(host.call(), 1);
  EXPECT_EQ(host.caller.message(), "ffp: feedforward off: no valid lidar wind speed");
  EXPECT_EQ(swap.get(Rec::FeedforwardPitchRate), 0.0);
  EXPECT_EQ(swap.get(Rec::FeedforwardActive), 0.0);
}

// Behind our master with their LDP, which knows only the block: that REWS counts.
TEST(GuoFfpLibrary, TheirLdpBehindOurMaster) {
  const TempFolder folder;
  GuoHost host("liblac_ffp", folder.write("f.IN", test::guo_ffp_v1(0, 1.0, 0.0)), 1,
               kPrivateArraySize);
  host.put_rews(17.0);
  host.call();
  EXPECT_EQ(host.caller.swap().get(Rec::RewsBuffered), 17.0);
}

// Neither: told once, off, the run goes on.
TEST(GuoFfpLibrary, NoWindSpeedToRead) {
  const TempFolder folder;
  GuoHost host("liblac_ffp", folder.write("f.IN", test::guo_ffp_v1(0, 1.0, 0.0)), 1,
               kPrivateArraySize);
  host.caller.swap().set(Rec::LogStart, 0.0);
  EXPECT_EQ(host.call(), 1);
  EXPECT_THAT(host.caller.message(), HasSubstr("no wind speed to read"));
  EXPECT_EQ(host.call(), 0);
  EXPECT_EQ(host.caller.swap().get(Rec::FeedforwardReason), 1.0);
}

// LegacyTiming through the library: REWS at call 100 is REWS_b at call 338.
TEST(GuoFfpLibrary, LegacyTiming) {
  const TempFolder folder;
  GuoHost host("liblac_ffp",
               folder.write("f.IN", test::guo_ffp_v1(0, 1.0, 3.0) + test::kGuoLegacy));
  for (int call = 0; call < 345; ++call) {
    host.put_rews(call < 100 ? 12.0 : 13.0);
    const int fail = host.call();
    EXPECT_EQ(fail, call == 0 ? 1 : 0);
    EXPECT_EQ(host.result(guo_lidar::kRewsBuffered), call < 338 ? 12.0 : 13.0) << call;
    EXPECT_NEAR(host.result(guo_lidar::kPitchRate), call == 338 ? 0.8 : 0.0, 1e-6) << call;
  }
}

// A step allocates nothing, in both.
TEST(GuoFfpLibrary, StepsDoNotAllocate) {
  const TempFolder folder;
  for (const std::string& more : {std::string(), test::kGuoLegacy}) {
    GuoHost host("liblac_ffp", folder.write("f.IN", test::guo_ffp_v2(1, 1, 0.5) + more));
    host.put_rews(14.0);
    host.call();
    const test::NoAllocGuard guard;
    for (int i = 0; i < 200; ++i) {
      host.put_rews(14.0 + 0.01 * i);
      host.call();
    }
    EXPECT_EQ(guard.allocations(), 0U);
  }
}

}  // namespace
}  // namespace lac
