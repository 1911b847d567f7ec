// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp_params.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "support/error_text.hpp"

namespace lac {
namespace {

constexpr const char* kGood =
    "12 16 ! CutOffWindSpeed\n0.03 0.04 ! CutOffFrequency\n"
    "10 12 14 ! StaticWind\n0 3 6 ! StaticPitch\n";

std::string error_of(const std::string& text) {
  InputFile in = InputFile::parse(text, "ffp.IN");
  return test::error_text([&] { FfpParams::read(in); });
}

// Degrees in the file, radians inside; the rest keeps its default.
TEST(FfpParams, ReadsDegrees) {
  InputFile in = InputFile::parse(kGood, "ffp.IN");
  const FfpParams p = FfpParams::read(in);
  EXPECT_NEAR(p.static_pitch_rad.at(14.0), rad_from_deg(6.0), 1e-15);
  EXPECT_EQ(p.threshold_mps, 14.0);
}

// Each mistake is named with file, line, key, what was found and expected.
TEST(FfpParams, Mistakes) {
  const std::string good = kGood;
  EXPECT_THAT(error_of(good + "3 ! FadeTim\n"),
              testing::AllOf(testing::HasSubstr("ffp.IN:5: FadeTim: unknown key"),
                             testing::HasSubstr("did you mean 'FadeTime'")));
  EXPECT_THAT(error_of("12 16 ! CutOffWindSpeed\n0.03 ! CutOffFrequency\n"),
              testing::HasSubstr("ffp.IN:2: CutOffFrequency: found 1 values, expected 2"));
  EXPECT_THAT(error_of("16 12 ! CutOffWindSpeed\n0.03 0.04 ! CutOffFrequency\n"),
              testing::HasSubstr("is not above the one before it"));
  EXPECT_THAT(error_of("12 16 ! CutOffWindSpeed\n0.03 0.04 ! CutOffFrequency\n"
                       "10 12 ! StaticWind\n3 2 ! StaticPitch\n"),
              testing::HasSubstr("ffp.IN:4: StaticPitch: value 2 (2"));
  EXPECT_THAT(error_of("12 16 ! CutOffWindSpeed\n0.03 zero ! CutOffFrequency\n"),
              testing::HasSubstr("found 'zero', expected a number above 0"));
}

// The bilinear filter has no cut-off above half the sampling rate, and a fade takes a step at
// least.
TEST(FfpParams, TimeStepTooLong) {
  const auto refusal = [](const std::string& row, double time_step_s) {
    InputFile in = InputFile::parse(kGood + row, "ffp.IN");
    try {
      FfpParams::read(in).check_time_step(in, time_step_s);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal("2 ! FadeTime\n", 0.1), "accepted");
  EXPECT_THAT(refusal("", 12.5), testing::HasSubstr("ffp.IN:2: CutOffFrequency: found 0.04 Hz, "
                                                    "expected less than 0.04 Hz"));
  EXPECT_THAT(refusal("0.1 0.2 ! CutOffTurbulence\n1 2 ! CutOffTurbulenceFactor\n", 6.5),
              testing::HasSubstr("CutOffFrequency: found 0.08 Hz"));
  EXPECT_THAT(refusal("5 ! DelayFrequency\n", 0.1), testing::HasSubstr("ffp.IN:5: DelayFreq"));
  EXPECT_THAT(refusal("1e-9 ! FadeTime\n", 0.0125),
              testing::HasSubstr("ffp.IN:5: FadeTime: found 1e-09 s, expected at least one step"));
}

// Keys that others make meaningless are refused, and so is what only looks like a pair.
TEST(FfpParams, KeysThatContradictEachOther) {
  const std::string good = kGood;
  EXPECT_EQ(error_of(good + "2 ! FilterOrder\n0.8 0.7 ! FilterDamping\n"), "no error");
  EXPECT_THAT(error_of(good + "2 ! FilterOrder\n0.8 ! FilterDamping\n"),
              testing::HasSubstr("ffp.IN:6: FilterDamping: found 1 values, expected 2"));
  EXPECT_THAT(error_of(good + "0.8 0.7 ! FilterDamping\n"),
              testing::HasSubstr("FilterDamping: has no meaning with FilterOrder 1"));
  EXPECT_THAT(error_of(good + "3 ! FilterOrder\n"), testing::HasSubstr("FilterOrder"));
  EXPECT_THAT(error_of(good + "1 ! FixedBuffer\n0 ! BufferTrim\n"),
              testing::HasSubstr("BufferTrim: has no meaning with FixedBuffer"));
  EXPECT_THAT(error_of(good + "61 ! FixedBuffer\n"), testing::HasSubstr("FixedBuffer"));
  EXPECT_EQ(error_of(good + "12 20 ! BufferTrimWindSpeed\n-0.5 -0.2 ! BufferTrim\n"), "no error");
  EXPECT_THAT(error_of(good + "-0.5 -0.2 ! BufferTrim\n"), testing::HasSubstr("BufferTrim"));
  EXPECT_EQ(error_of(good + "blend ! Entry\n12 15 ! BlendSpeeds\n"), "no error");
  EXPECT_THAT(error_of(good + "blend ! Entry\n15 12 ! BlendSpeeds\n"),
              testing::HasSubstr("expected a second speed above the first"));
  EXPECT_THAT(error_of(good + "blend ! Entry\n12 15 ! BlendSpeeds\n14 ! ThresholdSpeed\n"),
              testing::HasSubstr("ThresholdSpeed: has no meaning unless Entry is threshold"));
  EXPECT_THAT(error_of(good + "slope ! Entry\n"), testing::HasSubstr("LargestSlope"));
  EXPECT_THAT(error_of(good + "1 2 3 ! ReducedStaticPitch\n"),
              testing::HasSubstr("ReducedPowerLevel"));
  EXPECT_THAT(error_of(good + "3 2 1 ! ReducedStaticPitch\n0.5 ! ReducedPowerLevel\n"),
              testing::HasSubstr("value 2 (2"));
  EXPECT_THAT(error_of(good + "1 2 ! CutOffTurbulenceFactor\n"),
              testing::HasSubstr("without CutOffTurbulence"));
}

// A hysteresis that reaches below zero would keep the feedforward on for ever.
TEST(FfpParams, HysteresisBeyondTheThreshold) {
  EXPECT_THAT(error_of(std::string(kGood) + "3 ! ThresholdSpeed\n4 ! Hysteresis\n"),
              testing::HasSubstr("ffp.IN:6: Hysteresis: found 4 m"));
}

}  // namespace
}  // namespace lac
