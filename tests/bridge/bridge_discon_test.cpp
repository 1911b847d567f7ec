// SPDX-License-Identifier: Apache-2.0
// The built library through its C entry, as the master calls it.
#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "support/discon_caller.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using test::DisconCaller;

class BridgeLibrary : public testing::Test {
 protected:
  std::string input(const std::string& route, const std::string& derating = "none") const {
    return folder.write("bridge.IN", route + " ! FeedforwardRoute\n30 ! LeakTime\n5 ! Authority\n" +
                                         "0.01 ! TowerDamperGain\n0 ! MinimumPitch\n" +
                                         "90 ! MaximumPitch\n10 ! MaximumPitchRate\n" + derating +
                                         " ! DeratingRoute\n");
  }

  /// What host, ffp and the neighbour put there in a step.
  static void fill(SwapView swap, double rate_radps) {
    swap.set(Rec::TowerForeAftAcceleration, 0.7);
    swap.set(Rec::TowerSideSideAcceleration, -0.3);
    swap.set(Rec::HubWindSpeed, 17.0);
    swap.set(Rec::NacelleDirection, 0.3);
    swap.set(Rec::FeedforwardPitchRate, rate_radps);
    swap.set(Rec::FeedforwardActive, 1.0);
    swap.set(Rec::PowerLevel, 0.9);
    swap.set(Rec::PowerLevelValid, 1.0);
    for (const Rec demand :
         {Rec::PitchDemand1, Rec::PitchDemand2, Rec::PitchDemand3, Rec::PitchDemandCollective}) {
      swap.set(demand, 0.25);
    }
  }

  test::TempFolder folder;
};

// tower_damper: both accelerations are replaced, the demands are not.
TEST_F(BridgeLibrary, TowerDamper) {
  DisconCaller caller("liblac_bridge", input("tower_damper"));
  fill(caller.swap(), 0.02);
  ASSERT_EQ(caller.call(0), 0) << caller.message();
  const double x_rad = caller.swap().get(Rec::BridgePitchIncrement);
  EXPECT_NEAR(x_rad, 0.02 * 0.0125, 1e-7);
  const double acceleration_mps2 = x_rad / (0.01 * 0.0125);
  EXPECT_NEAR(caller.swap().get(Rec::TowerForeAftAcceleration), acceleration_mps2 * std::cos(0.3),
              1e-6);
  EXPECT_NEAR(caller.swap().get(Rec::TowerSideSideAcceleration), acceleration_mps2 * std::sin(0.3),
              1e-6);
  EXPECT_EQ(caller.swap().get(Rec::PitchDemand1), 0.25);
}

// added: the four demands alike, the accelerations stay.
TEST_F(BridgeLibrary, Added) {
  DisconCaller caller("liblac_bridge", input("added"));
  for (int i = 0; i < 800; ++i) {
    fill(caller.swap(), 0.002);
    ASSERT_EQ(caller.call(i == 0 ? 0 : 1), 0) << caller.message();
  }
  const double sum_rad = 0.25 + 0.002 * 30.0 * -std::expm1(-10.0 / 30.0);
  for (const Rec demand :
       {Rec::PitchDemand1, Rec::PitchDemand2, Rec::PitchDemand3, Rec::PitchDemandCollective}) {
    EXPECT_NEAR(caller.swap().get(demand), sum_rad, 1e-6);
  }
  EXPECT_FLOAT_EQ(static_cast<float>(caller.swap().get(Rec::TowerForeAftAcceleration)), 0.7F);
  EXPECT_EQ(caller.swap().get(Rec::BridgeLimited), 0.0);
}

// hub_wind: record 27 and its copy.
TEST_F(BridgeLibrary, HubWind) {
  DisconCaller caller("liblac_bridge", input("none", "hub_wind"));
  for (int i = 0; i < 1000; ++i) {
    fill(caller.swap(), 0.0);
    ASSERT_EQ(caller.call(i == 0 ? 0 : 1), 0) << caller.message();
  }
  EXPECT_FLOAT_EQ(static_cast<float>(caller.swap().get(Rec::HubWindSpeed)), 18.0F);
  EXPECT_FLOAT_EQ(static_cast<float>(caller.swap().get(Rec::BridgeWindSpeed)), 18.0F);
}

// none: not one record is touched, but for the mark every library of ours leaves.
TEST_F(BridgeLibrary, NoneTouchesNothing) {
  DisconCaller caller("liblac_bridge", input("none"));
  fill(caller.swap(), 0.02);
  ASSERT_EQ(caller.call(0), 0) << caller.message();
  const auto copy = [&] {
    return std::vector<float>(caller.swap().data(), caller.swap().data() + caller.swap().size());
  };
  std::vector<float> before = copy();
  ASSERT_EQ(caller.call(1), 0);
  before[static_cast<std::size_t>(Rec::Status) - 1] = 1.0F;
  before[static_cast<std::size_t>(Rec::Time) - 1] = 0.0125F;
  EXPECT_EQ(copy(), before);
}

// Nobody in front who could know the feedforward or the level: told in the first call only.
TEST_F(BridgeLibrary, MissingSourcesAreToldOnce) {
  DisconCaller caller("liblac_bridge", input("tower_damper", "hub_wind"));
  EXPECT_EQ(caller.call(0), 1);
  EXPECT_THAT(caller.message(), testing::HasSubstr("has written a feedforward: is ffp missing"));
  EXPECT_THAT(caller.message(), testing::HasSubstr("has written a power level: is ti_estimator"));
  EXPECT_EQ(caller.call(1), 0);
}

// Without the master there is nothing to bridge.
TEST_F(BridgeLibrary, NeedsTheMaster) {
  DisconCaller caller("liblac_bridge", input("none"), kExtendedArraySize);
  EXPECT_EQ(caller.call(0), -1);
  EXPECT_THAT(caller.message(), testing::HasSubstr("behind the LAC wrapper"));
}

}  // namespace
}  // namespace lac
