// SPDX-License-Identifier: Apache-2.0
// The three examples as secondaries in one chain under the master (examples/chain.IN).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "examples/example_library.hpp"
#include "support/discon_caller.hpp"
#include "support/temp_folder.hpp"

namespace lac::test {
namespace {

class ExampleChain : public testing::Test {
 protected:
  void SetUp() override {
    if (!kMinimumPitch.built) GTEST_SKIP() << kNoFortran;
  }
  DisconCaller caller(const std::string& root) const {
    return DisconCaller("liblac_wrapper", LAC_SOURCE_DIR "/examples/chain.IN", kExtendedArraySize,
                        folder.file(root + ".SrvD"));
  }
  /// A turbine at work with the blades at 14 deg; wind and speed as given.
  static void step(DisconCaller& host, int n, double wind_mps, double speed_rpm) {
    host.swap().set(Rec::PitchBlade1, rad_from_deg(14.0));
    host.swap().set(Rec::HubWindSpeed, wind_mps);
    host.swap().set(Rec::GeneratorSpeed, radps_from_rpm(speed_rpm));
    host.swap().set(Rec::TowerForeAftAcceleration, std::sin(0.025 * n));
    const int fail = host.call(n == 0 ? LAC_STATUS_FIRST : LAC_STATUS_STEP);
    ASSERT_GE(fail, 0) << host.message();
    if (fail > 0) warnings().push_back(host.message());
  }
  static std::vector<std::string>& warnings() {
    static std::vector<std::string> all;
    return all;
  }

  TempFolder folder;
};

// Each does its part in the same array: the minimum pitch at 12 m/s is 3.5 deg where the feedback
// controller, at 95 % of rated speed, asks for none.
TEST_F(ExampleChain, MinimumPitchIsDemanded) {
  DisconCaller host = caller("run");
  for (int n = 0; n < 4000; ++n) step(host, n, 12.0, 1115.0);
  for (int r = 42; r <= 45; ++r) EXPECT_NEAR(deg_from_rad(host.swap().at(r)), 3.5, 0.01);
  EXPECT_EQ(host.call(LAC_STATUS_LAST), 0);
}

// Three events lower the power level to 0.7, it is 0.716 after 50 s: the torque demand follows, and
// the warnings reach the host with the name of the secondary.
TEST_F(ExampleChain, SupervisorLowersTorque) {
  warnings().clear();
  DisconCaller host = caller("run");
  for (int n = 0; n < 4000; ++n) step(host, n, 18.0, 1173.7);
  const double before_Nm = host.swap().get(Rec::TorqueDemand);
  int n = 4000;
  for (int event = 0; event < 3; ++event) {
    step(host, n++, 18.0, 1321.0);
    step(host, n++, 18.0, 1173.7);
  }
  for (; n < 8000; ++n) step(host, n, 18.0, 1173.7);
  EXPECT_NEAR(host.swap().get(Rec::TorqueDemand) / before_Nm, 0.716, 0.005);
  EXPECT_THAT(warnings(), testing::Contains(testing::HasSubstr("speed_supervisor (")));
}

// Two turbines in one process: the static state of the C and Fortran examples is not shared.
TEST_F(ExampleChain, TwoTurbines) {
  const auto fly = [](DisconCaller& a, DisconCaller* b) {
    for (int n = 0; n < 2000; ++n) {
      step(a, n, 11.0 + std::sin(0.01 * n), 1160.0);
      if (b != nullptr) step(*b, n, 20.0, 1200.0);
    }
    return std::vector<float>(a.swap().data(), a.swap().data() + 164);
  };
  DisconCaller alone = caller("alone");
  std::vector<float> expected = fly(alone, nullptr);
  alone.call(LAC_STATUS_LAST);
  DisconCaller first = caller("first");
  DisconCaller second = caller("second");
  std::vector<float> together = fly(first, &second);
  expected[50] = together[50];  // length of the root name
  EXPECT_EQ(together, expected);
}

}  // namespace
}  // namespace lac::test
