// SPDX-License-Identifier: Apache-2.0
#include "ldp/ldp_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"

namespace lac {
namespace {

using testing::HasSubstr;

constexpr const char* kGood = "4 ! NumberOfBeams\n1 ! ScanTime\n";

std::string refusal(const std::string& rows, double time_step_s = 0.0125) {
  InputFile in = InputFile::parse(rows, "ldp.IN");
  try {
    LdpParams::read(in).check_time_step(in, time_step_s);
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

// Few keys are needed; a short mean settles within its own window.
TEST(LdpParams, Defaults) {
  InputFile in = InputFile::parse(std::string(kGood) + "4 ! MeanSpeedWindow\n", "ldp.IN");
  const LdpParams p = LdpParams::read(in);
  EXPECT_EQ(p.settling_time_s, 4.0);
  EXPECT_EQ(p.minimum_samples, 4);
  EXPECT_EQ(p.maximum_age_s, 2.0);
  EXPECT_EQ(refusal(kGood), "accepted");
}

// On OpenFAST's block one measurement brings all points: its interval is the scan.
TEST(LdpParams, OpenFastDefaults) {
  const std::string openfast =
      "openfast ! LidarLayout\n2 ! InterpolationOrder\n-5 ! RotorPositionX\n";
  InputFile in = InputFile::parse(openfast + "0.25 ! MeasurementInterval\n", "ldp.IN");
  const LdpParams p = LdpParams::read(in);
  EXPECT_EQ(p.scan_time_s, 0.25);
  EXPECT_EQ(p.maximum_age_s, 0.5);
  EXPECT_EQ(p.minimum_samples, 1);
  EXPECT_THAT(refusal(openfast), HasSubstr("ScanTime"));
  EXPECT_EQ(refusal(openfast + "0.5 ! ScanTime\n"), "accepted");
  EXPECT_THAT(refusal(std::string(kGood) + "2 ! InterpolationOrder\n"),
              HasSubstr("InterpolationOrder"));
}

// Keys of what is not used are refused, those of what is used are asked for.
TEST(LdpParams, KeysOnDemand) {
  const std::string good = kGood;
  const std::string place = "90 ! HubHeight\n63 ! RotorRadius\n";
  const std::string thrust = "5 15 ! InductionWindSpeed\n0.8 0.3 ! InductionThrust\n";
  const std::string cylinder = good + "vortex_cylinder ! InductionModel\n";
  EXPECT_EQ(refusal(cylinder + place + thrust), "accepted");
  EXPECT_THAT(refusal(cylinder + place), HasSubstr("InductionWindSpeed"));
  EXPECT_THAT(refusal(cylinder + thrust), HasSubstr("HubHeight"));
  EXPECT_THAT(refusal(good + thrust), HasSubstr("InductionWindSpeed"));
  EXPECT_THAT(refusal(cylinder + place + "5 15 ! InductionWindSpeed\n0.8 1.5 ! InductionThrust\n"),
              HasSubstr("InductionThrust"));
  EXPECT_THAT(refusal("openfast ! LidarLayout\n0.5 ! ScanTime\n2 ! InterpolationOrder\n" +
                      std::string("-5 ! RotorPositionX\nvortex_cylinder ! InductionModel\n") +
                      place + thrust),
              HasSubstr("expected one_dimensional or none with LidarLayout openfast"));
  EXPECT_THAT(refusal(good + "2 ! SpikeFloor\n"), HasSubstr("SpikeFloor"));
  EXPECT_THAT(refusal(good + "9 ! AvailabilityAlarmTime\n"), HasSubstr("AvailabilityAlarmTime"));
  EXPECT_THAT(refusal(good + "wind ! TravelSpeed\n"), HasSubstr("expected"));
}

// Nothing is shortened or lengthened in silence: what cannot be is refused with line and key.
TEST(LdpParams, Mistakes) {
  const std::string good = kGood;
  EXPECT_THAT(refusal(good + "9 ! MeanSpeedWindow\n10 ! SettlingTime\n"),
              HasSubstr("ldp.IN:4: SettlingTime: found 10 s"));
  EXPECT_THAT(refusal("4 ! NumberOfBeams\n1e-9 ! ScanTime\n"),
              HasSubstr("ldp.IN:2: ScanTime: found 1e-09 s, expected at least one step of 0.0125"));
  EXPECT_THAT(refusal(good + "0.01 ! MeanSpeedWindow\n"), HasSubstr("ldp.IN:3: MeanSpeedWindow"));
  EXPECT_THAT(refusal(good + "0.01 ! MaximumAge\n"), HasSubstr("ldp.IN:3: MaximumAge"));
  EXPECT_THAT(refusal(good + "1.9 ! LongestLead\n1 ! RequiredLead\n"),
              HasSubstr("expected more than RequiredLead plus ScanTime"));
  EXPECT_EQ(refusal("1 ! NumberOfBeams\n0.0125 ! ScanTime\n"), "accepted");
}

}  // namespace
}  // namespace lac
