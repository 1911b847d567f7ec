// SPDX-License-Identifier: Apache-2.0
// The built library through its C entry, as a host and as the master call it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "feedback/nrel5mw.hpp"
#include "support/discon_caller.hpp"

namespace lac {
namespace {

using test::DisconCaller;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kRated_radps = 122.9096;

/// An input file beside the shipped one's text, with one line replaced and the table's full path.
std::string variant(const std::string& name, const std::string& key, const std::string& line) {
  std::string text = test::shipped_text(key, line);
  const std::string relative = "../turbines";
  text.replace(text.find(relative), relative.size(), LAC_SOURCE_DIR "/config/turbines");
  std::string path = testing::TempDir() + "lac_feedback_" + name + ".IN";
  std::ofstream(path) << text;
  return path;
}

void measure(SwapView swap, double generator_speed_radps, double pitch_rad) {
  swap.set(Rec::GeneratorSpeed, generator_speed_radps);
  swap.set(Rec::RotorSpeed, generator_speed_radps / 97.0);
  swap.set(Rec::PitchBlade1, pitch_rad);
}

// A host without any extension: 164 records, the shipped file. All demands are there, and no other
// record is touched.
TEST(FeedbackLibrary, RunsAloneOn164Records) {
  DisconCaller caller("liblac_feedback", test::kShippedInput, kHostBlock.last());
  SwapView swap = caller.swap();
  std::set<int> written;
  for (const Rec r :
       {Rec::GeneratorContactor, Rec::ShaftBrake, Rec::YawTorqueDemand, Rec::PitchDemand1,
        Rec::PitchDemand2, Rec::PitchDemand3, Rec::PitchDemandCollective, Rec::PitchRateDemand,
        Rec::TorqueDemand, Rec::YawRateDemand, Rec::PitchOverride, Rec::TorqueOverride,
        Rec::StartupResistance, Rec::LoadRequest, Rec::SlipCurrentFlag, Rec::SlipCurrentDemand}) {
    written.insert(static_cast<int>(r));
    swap.set(r, -77.0);
  }
  for (int i = 0; i < 200; ++i) {
    measure(swap, kRated_radps, 0.26);
    swap.set(Rec::Status, i == 0 ? 0.0 : 1.0);
    swap.set(Rec::Time, i * caller.time_step_s);
    const std::vector<float> before(swap.data(), swap.data() + swap.size());
    ASSERT_EQ(caller.call(i == 0 ? 0 : 1), 0) << caller.message();
    for (int r = 3; r <= swap.size(); ++r) {
      if (written.contains(r)) continue;
      ASSERT_EQ(swap.data()[r - 1], before[static_cast<std::size_t>(r - 1)]) << r;
    }
  }
  EXPECT_EQ(swap.get(Rec::GeneratorContactor), 1.0);
  for (const Rec r :
       {Rec::PitchDemand1, Rec::PitchDemand2, Rec::PitchDemand3, Rec::PitchDemandCollective}) {
    EXPECT_NEAR(swap.get(r), 0.26, 1e-4);
  }
  EXPECT_NEAR(swap.get(Rec::TorqueDemand), 43093.55, 1.0);
  for (const Rec r :
       {Rec::ShaftBrake, Rec::YawTorqueDemand, Rec::PitchRateDemand, Rec::YawRateDemand,
        Rec::PitchOverride, Rec::TorqueOverride, Rec::StartupResistance, Rec::LoadRequest,
        Rec::SlipCurrentFlag, Rec::SlipCurrentDemand}) {
    EXPECT_EQ(swap.get(r), 0.0) << static_cast<int>(r);
  }
  EXPECT_EQ(caller.call(-1), 0);
}

// Not a number in a record it needs: demands hold, one warning at each end, the run goes on.
TEST(FeedbackLibrary, HoldsOnNotANumber) {
  DisconCaller caller("liblac_feedback", test::kShippedInput, kHostBlock.last());
  int warnings = 0;
  for (int i = 0; i < 300; ++i) {
    const bool bad = i >= 100 && i < 200;
    measure(caller.swap(), bad ? NAN : kRated_radps + 0.001 * i, 0.26);
    const double held = caller.swap().get(Rec::PitchDemand1);
    const int fail = caller.call(i == 0 ? 0 : 1);
    ASSERT_GE(fail, 0);
    warnings += fail;
    if (bad) {
      ASSERT_EQ(caller.swap().get(Rec::PitchDemand1), held);
    }
    if (i == 100) {
      EXPECT_THAT(caller.message(), HasSubstr("demands hold"));
    }
    if (i == 200) {
      EXPECT_THAT(caller.message(), HasSubstr("recovered after 100 steps"));
    }
  }
  EXPECT_EQ(warnings, 2);
}

// Behind the master the feedforward rate of the chain moves the demand, and the own records of
// the chain are filled in.
TEST(FeedbackLibrary, WorksInTheChain) {
  DisconCaller caller("liblac_feedback",
                      variant("ff", "UseFeedforward", "true ! UseFeedforward - x"));
  SwapView swap = caller.swap();
  for (int i = 0; i <= 80; ++i) {
    measure(swap, kRated_radps, 0.26);
    swap.set(Rec::FeedforwardPitchRate, 0.01);
    ASSERT_EQ(caller.call(i == 0 ? 0 : 1), 0) << caller.message();
  }
  EXPECT_NEAR(swap.get(Rec::PitchDemandCollective), 0.26 + 0.01, 1e-5);
  EXPECT_NEAR(swap.get(Rec::FeedbackSpeedFiltered), kRated_radps, 1e-3);
  EXPECT_EQ(swap.get(Rec::FeedbackRegion), 3.0);
  EXPECT_NEAR(swap.get(Rec::FeedbackPitchIntegral), 0.27, 1e-4);
  EXPECT_GT(swap.get(Rec::FeedbackSetPointFade), 1.0);

  swap.set(Rec::ChainInputsGood, 0.0);
  EXPECT_EQ(caller.call(1), 1);
  EXPECT_NEAR(swap.get(Rec::PitchDemandCollective), 0.27, 1e-5);
  swap.set(Rec::ChainInputsGood, 1.0);
  swap.set(Rec::FeedforwardPitchRate, NAN);
  EXPECT_EQ(caller.call(1), 1);
  EXPECT_THAT(caller.message(), AllOf(HasSubstr("recovered"), HasSubstr("feedforward pitch rate")));
  EXPECT_EQ(caller.call(1), 0);
  EXPECT_NEAR(swap.get(Rec::PitchDemandCollective), 0.27, 1e-5);
}

// The power level of the chain counts once it is valid.
TEST(FeedbackLibrary, TakesThePowerLevelOfTheChain) {
  DisconCaller caller("liblac_feedback",
                      variant("level", "UsePowerLevel", "true ! UsePowerLevel - x"));
  SwapView swap = caller.swap();
  for (int i = 0; i <= 80 * 20; ++i) {
    measure(swap, kRated_radps, 0.26);
    swap.set(Rec::PowerLevel, 0.9);
    swap.set(Rec::PowerLevelValid, i < 80 ? 0.0 : 1.0);
    ASSERT_EQ(caller.call(i == 0 ? 0 : 1), 0) << caller.message();
    if (i == 79) {
      EXPECT_NEAR(swap.get(Rec::TorqueDemand), 43093.55, 1.0);
    }
  }
  EXPECT_NEAR(swap.get(Rec::TorqueDemand), 0.9 * 43093.55, 1.0);
}

// What needs the chain is refused without it, with the line of the key.
TEST(FeedbackLibrary, NeedsTheMasterForTheChain) {
  for (const std::string key : {"UseFeedforward", "UsePowerLevel"}) {
    DisconCaller caller("liblac_feedback", variant(key, key, "true ! " + key + " - x"),
                        kHostBlock.last());
    measure(caller.swap(), kRated_radps, 0.26);
    EXPECT_LT(caller.call(0), 0);
    EXPECT_THAT(caller.message(), AllOf(HasSubstr(key), HasSubstr("wrapper")));
  }
}

// A wrong input file and a time step too long fail with a message.
TEST(FeedbackLibrary, RefusesBadStarts) {
  DisconCaller wrong("liblac_feedback", variant("bad", "MaximumTorque", "1 ! MaximumTorque - x"));
  EXPECT_LT(wrong.call(0), 0);
  EXPECT_THAT(wrong.message(), AllOf(HasSubstr("feedback: "), HasSubstr(":6: MaximumTorque")));
  DisconCaller slow("liblac_feedback", test::kShippedInput);
  slow.set_time_step(2.0);
  EXPECT_LT(slow.call(0), 0);
  EXPECT_THAT(slow.message(), HasSubstr("SpeedLowPass"));
}

// Kept at -11 and brought back at -10, the same inputs give the same demands.
TEST(FeedbackLibrary, RestoresWhatWasStored) {
  DisconCaller caller("liblac_feedback", test::kShippedInput, kHostBlock.last());
  const auto run = [&](int from, int to) {
    for (int i = from; i < to; ++i) {
      measure(caller.swap(), 122.0 + 2.0 * std::sin(0.02 * i), 0.2);
      EXPECT_EQ(caller.call(i == 0 ? 0 : 1), 0) << caller.message();
    }
    return std::pair(caller.swap().get(Rec::PitchDemand1), caller.swap().get(Rec::TorqueDemand));
  };
  run(0, 500);
  ASSERT_EQ(caller.call(-11), 0);
  const auto straight = run(500, 900);
  ASSERT_EQ(caller.call(-10), 0);
  EXPECT_EQ(run(500, 900), straight);
}

}  // namespace
}  // namespace lac
