// SPDX-License-Identifier: Apache-2.0
#include "feedback/feedback_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "feedback/nrel5mw.hpp"
#include "support/error_text.hpp"

namespace lac {
namespace {

using test::parsed;
using test::shipped_text;
using testing::AllOf;
using testing::HasSubstr;

std::string error_of(const std::string& text) {
  return test::error_text([&] { parsed(text); });
}

/// The shipped file with its design keys replaced by `lines`.
std::string with_given_gains(const std::string& lines) {
  const std::string text = shipped_text("Gains", "given ! Gains - x");
  return text.substr(0, text.find("\"../turbines")) + lines;
}

const std::string kGiven =
    "0 10 20 ! GainSchedulePitch - [deg]\n0.02 0.01 0.005 ! ProportionalGain - [s]\n"
    "3 2 1 ! IntegralTime - [s]\n3000 ! TorqueProportionalGain - x\n"
    "2.5 ! TorqueIntegralTime - [s]\n2.33 ! OptimalTorqueGain - x\n";

// The shipped file: rpm, deg and kW of the file are SI inside.
TEST(FeedbackParams, ReadsTheShippedFile) {
  const FeedbackParams p = test::shipped_params();
  EXPECT_NEAR(p.torque.rated_speed_radps, 12.1 * 97.0 * kPi / 30.0, 1e-9);
  EXPECT_NEAR(p.torque.rated_speed_radps * p.torque.rated_torque_Nm * 0.944, 5.0e6, 50.0);
  EXPECT_NEAR(p.pitch.max_rate_radps, 0.139626, 1e-6);
  EXPECT_NEAR(p.fading.power_range_W, 5.0e6, 1e-6);
  EXPECT_NEAR(p.fading.speed_range_radps, 12.291, 1e-3);
  EXPECT_NEAR(p.torque.optimal_gain_Nms2prad2, 2.3323, 1e-12);
  EXPECT_EQ(p.pitch.gains.proportional_s.x().size(), 4U);
  EXPECT_FALSE(p.use_feedforward);
  EXPECT_FALSE(p.use_actuator);
}

// The file of the lidar-assisted chain differs in UseFeedforward alone.
TEST(FeedbackParams, LidarAssistedFileDiffersInOneKey) {
  const auto without_comments = [](const std::string& text) {
    std::string result;
    std::istringstream lines(text);
    for (std::string one; std::getline(lines, one);) {
      if (!one.starts_with('!')) result += one + "\n";
    }
    return result;
  };
  std::ifstream file(LAC_SOURCE_DIR "/config/nrel5mw/feedback_lac.IN");
  std::stringstream assisted;
  assisted << file.rdbuf();
  EXPECT_TRUE(parsed(assisted.str()).use_feedforward);
  std::string expected = without_comments(shipped_text());
  const std::size_t line = expected.rfind('\n', expected.find("! UseFeedforward")) + 1;
  expected.replace(line, 5, "true ");
  EXPECT_EQ(without_comments(assisted.str()), expected);
}

// Without OptimalTorqueGain the rotor table gives it.
TEST(FeedbackParams, DesignsTheRegion2Gain) {
  EXPECT_NEAR(parsed(shipped_text("OptimalTorqueGain")).torque.optimal_gain_Nms2prad2, 2.3689,
              0.03);
}

// Gains can be given instead of designed.
TEST(FeedbackParams, ReadsGivenGains) {
  const FeedbackParams p = parsed(with_given_gains(kGiven));
  EXPECT_NEAR(p.pitch.gains.at(rad_from_deg(15.0)).proportional, 0.0075, 1e-12);
  EXPECT_NEAR(p.pitch.gains.at(rad_from_deg(15.0)).integral_time_s, 1.5, 1e-12);
  EXPECT_EQ(p.torque.gains.proportional, 3000.0);
  EXPECT_EQ(p.torque.gains.integral_time_s, 2.5);
}

// Constant torque above rated changes the design: less damping is asked of the controller.
TEST(FeedbackParams, ConstantTorqueLowersTheGains) {
  const FeedbackParams power = test::shipped_params();
  const FeedbackParams torque = parsed(shipped_text("AboveRated", "torque ! AboveRated - x"));
  EXPECT_EQ(torque.torque.above_rated, TorqueControl::AboveRated::ConstantTorque);
  EXPECT_LT(torque.pitch.gains.at(0.2).proportional, power.pitch.gains.at(0.2).proportional);
}

// Values that do not fit together are refused with file, line and key.
TEST(FeedbackParams, RefusesWhatDoesNotFit) {
  EXPECT_THAT(error_of(shipped_text("MaximumTorque", "40000 ! MaximumTorque - x")),
              AllOf(HasSubstr("feedback.IN:6: MaximumTorque"), HasSubstr("RatedTorque")));
  EXPECT_THAT(error_of(shipped_text("CutInSpeed", "800 ! CutInSpeed - x")),
              HasSubstr("LowSpeedSetPoint: found"));
  EXPECT_THAT(error_of(shipped_text("MaximumPitch", "-1 ! MaximumPitch - x")),
              HasSubstr("FinePitch"));
  EXPECT_THAT(error_of(shipped_text("FadingSpeed", "250 ! FadingSpeed - x")),
              AllOf(HasSubstr("FadingSpeed"), HasSubstr("250"), HasSubstr("198.85")));
  EXPECT_THAT(error_of(shipped_text("DesignWindSpeed", "16 12 ! DesignWindSpeed - x")),
              AllOf(HasSubstr("DesignWindSpeed"), HasSubstr("rise")));
  EXPECT_THAT(error_of(shipped_text("DesignWindSpeed", "8 12 ! DesignWindSpeed - x")),
              AllOf(HasSubstr("DesignWindSpeed"), HasSubstr("8 m/s is below rated")));
  EXPECT_THAT(error_of(shipped_text("RotorTable", "none.txt ! RotorTable - x")),
              AllOf(HasSubstr("RotorTable"), HasSubstr("none.txt")));
  EXPECT_THAT(error_of(shipped_text("Gains", "given ! Gains - x")),
              AllOf(HasSubstr("PitchLoopDamping"), HasSubstr("only if Gains is design")));
  EXPECT_THAT(error_of(shipped_text() + "3 ! IntegralTime - x\n"),
              AllOf(HasSubstr("IntegralTime"), HasSubstr("only if Gains is given")));
  EXPECT_THAT(error_of(shipped_text() + "3 ! FinePitsch - x\n"), HasSubstr("FinePitch"));
  EXPECT_THAT(error_of(with_given_gains("0 9 ! GainSchedulePitch - x\n1 ! ProportionalGain - x\n")),
              AllOf(HasSubstr("ProportionalGain"), HasSubstr("found 1 values, expected 2")));
}

// A time step too long for a filter is refused with the key and both numbers.
TEST(FeedbackParams, RefusesAStepTooLongForTheFilters) {
  const FeedbackParams p = test::shipped_params();
  const InputFile in = InputFile::parse(shipped_text(), "feedback.IN");
  EXPECT_NO_THROW(p.check_time_step(in, 0.1));
  try {
    p.check_time_step(in, 1.2);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("feedback.IN:"), HasSubstr("SpeedLowPass: found 0.5"),
                                    HasSubstr("0.41666")));
  }
}

}  // namespace
}  // namespace lac
