// SPDX-License-Identifier: Apache-2.0
// The built library through its C entry, as the master calls it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "core/rotor_aero.hpp"
#include "monitor/random_wind.hpp"
#include "support/discon_caller.hpp"
#include "support/temp_folder.hpp"
#include "support/test_host.hpp"

#include "support/no_alloc_guard.hpp"  // after <cstdlib>

namespace lac::test {
namespace {

const std::string kShipped = LAC_SOURCE_DIR "/config/nrel5mw/monitor.IN";
constexpr double kSpeed_radps = 1.2, kPitch_rad = 0.21;

/// What a turbine and its lidar write in one wind.
struct Turbine {
  explicit Turbine(unsigned seed) : wind(seed, 16.0, 0.8) {}

  void fill(SwapView swap, long step, double bias = 1.0) const {
    const double t = static_cast<double>(step) * 0.0125;
    static const RotorAero rotor{
        RotorTable::load(LAC_SOURCE_DIR "/config/turbines/nrel5mw/cp_ct.txt"), 63.0, 1.225};
    swap.set(Rec::GeneratorSpeed, 97.0 * kSpeed_radps);
    swap.set(Rec::GeneratorTorque, rotor.torque_Nm(wind.at(t), kSpeed_radps, kPitch_rad) / 97.0);
    swap.set(Rec::PitchBlade1, kPitch_rad);
    swap.set(Rec::GeneratorContactor, 1.0);
    swap.set(Rec::LidarRews, bias * wind.at(t + 3.5));
    swap.set(Rec::LidarRewsValid, 1.0);
    swap.set(Rec::LidarRewsLead, 4.0);
    swap.set(Rec::LidarScanWindow, 1.0);
    swap.set(Rec::FeedforwardCutOff, 0.05);
    swap.set(Rec::FeedforwardBufferTime, 1.27);  // 3.5 s less filter (2.01 s at 0.08 Hz), actuator
    swap.set(Rec::RewsBuffered, bias * wind.at(t + 0.22));
  }
  RandomWind wind;
};

/// An input file with nothing but what is needed, and the lines given.
std::string input(const TempFolder& folder, const std::string& lines) {
  return folder.write("monitor.IN",
                      "\"" LAC_SOURCE_DIR
                      "/config/turbines/nrel5mw/cp_ct.txt\" ! RotorTable -\n"
                      "63 ! RotorRadius -\n4.37e7 ! InertiaLowSpeedShaft -\n97 ! GearboxRatio -\n" +
                          lines);
}

std::vector<double> results(SwapView swap) {
  std::vector<double> values;
  for (const Rec r :
       {Rec::TurbineRews, Rec::TurbineRewsValid, Rec::MonitorAuthority, Rec::MonitorBufferTrim,
        Rec::MonitorDelay, Rec::MonitorCoherence, Rec::MonitorGain, Rec::MonitorReason}) {
    values.push_back(swap.get(r));
  }
  return values;
}

// A wrong lidar is told once, its recovery once, and all records are there.
TEST(MonitorLibrary, ToldOnceEachWay) {
  const Turbine turbine(3);
  const TempFolder folder;
  DisconCaller caller("liblac_monitor", input(folder, "50 ! Memory -\n"));
  std::vector<std::string> messages;
  for (long n = 0; n < 60000; ++n) {
    turbine.fill(caller.swap(), n, n > 10000 && n < 20000 ? 1.5 : 1.0);
    if (caller.call(n == 0 ? 0 : 1) != 0) messages.push_back(caller.message());
    if (n == 8000) {
      EXPECT_NEAR(caller.swap().get(Rec::TurbineRews), turbine.wind.at(100.0 - 0.32), 0.1);
      EXPECT_EQ(caller.swap().get(Rec::TurbineRewsValid), 1.0);
      EXPECT_EQ(caller.swap().get(Rec::MonitorAuthority), 1.0);
      EXPECT_EQ(caller.swap().get(Rec::MonitorReason), 0.0);
      EXPECT_NEAR(caller.swap().get(Rec::MonitorDelay), 3.5, 0.2);
      EXPECT_GT(caller.swap().get(Rec::MonitorCoherence), 0.95);
      EXPECT_NEAR(caller.swap().get(Rec::MonitorGain), 1.0, 0.05);
      EXPECT_EQ(caller.swap().get(Rec::MonitorBufferTrim), 0.0);
    }
  }
  ASSERT_EQ(messages.size(), 2U) << (messages.empty() ? "" : messages.back());
  EXPECT_THAT(messages[0], testing::HasSubstr("authority below 0.8"));
  EXPECT_THAT(messages[1], testing::HasSubstr("back above 0.95"));
}

// No generator, or inputs that the master holds: no wind speed, and it says so.
TEST(MonitorLibrary, NoWindWithoutGenerator) {
  const Turbine turbine(3);
  DisconCaller caller("liblac_monitor", kShipped);
  const auto valid_with = [&](Rec record, double value) {
    for (long n = 0; n < 200; ++n) {
      caller.swap().set(Rec::ChainInputsGood, 1.0);
      turbine.fill(caller.swap(), n);
      caller.swap().set(record, value);
      EXPECT_EQ(caller.call(n == 0 ? 0 : 1), 0) << caller.message();
    }
    EXPECT_EQ(std::isfinite(caller.swap().get(Rec::TurbineRews)),
              caller.swap().get(Rec::TurbineRewsValid) == 1.0);
    caller.call(-1);
    return caller.swap().get(Rec::TurbineRewsValid) == 1.0;
  };
  EXPECT_TRUE(valid_with(Rec::GeneratorContactor, 1.0));
  EXPECT_FALSE(valid_with(Rec::GeneratorContactor, 0.0));
  EXPECT_FALSE(valid_with(Rec::ChainInputsGood, 0.0));
  EXPECT_FALSE(valid_with(Rec::GeneratorTorque, 0.0));
  EXPECT_FALSE(valid_with(Rec::PitchBlade1, 1.0));
}

// Two turbines in one process, in turn, as each alone.
TEST(MonitorLibrary, TwoTurbinesAtOnce) {
  const Turbine first(3), second(4);
  const auto alone = [](const Turbine& turbine) {
    DisconCaller caller("liblac_monitor", kShipped);
    for (long n = 0; n < 8000; ++n) {
      turbine.fill(caller.swap(), n);
      caller.call(n == 0 ? 0 : 1);
    }
    return results(caller.swap());
  };
  DisconCaller a("liblac_monitor", kShipped), b("liblac_monitor", kShipped);
  for (long n = 0; n < 8000; ++n) {
    for (auto& [turbine, caller] : {std::pair{&first, &a}, std::pair{&second, &b}}) {
      turbine->fill(caller->swap(), n);
      caller->call(n == 0 ? 0 : 1);
    }
  }
  EXPECT_EQ(results(a.swap()), alone(first));
  EXPECT_EQ(results(b.swap()), alone(second));
  EXPECT_NE(results(a.swap()), results(b.swap()));
}

// Saved in the middle of an update interval and loaded by another instance, it goes on to the last
// bit.
TEST(MonitorLibrary, CheckpointContinuesExactly) {
  const Turbine turbine(5);
  const TempFolder folder;
  const DisconLibrary library = DisconLibrary::open("liblac_monitor", "DISCON", {LAC_LIBRARY_DIR});
  const auto host = [&](const char* name) {
    auto h =
        std::make_unique<TestHost>(library.entry(), kShipped, folder.file(name), kPrivateArraySize);
    h->set(Rec::ChainVersion, static_cast<float>(kChainLayoutVersion));
    h->set(Rec::ChainInputsGood, 1.0F);
    return h;
  };
  const auto run = [&](TestHost& h, long from, long to) {
    for (long n = from; n < to; ++n) {
      turbine.fill({h.array.data(), kPrivateArraySize}, n);
      ASSERT_GE(h.call(n == 0 ? 0 : 1), 0) << h.message();
    }
  };
  const auto whole = host("whole.SrvD"), half = host("half.SrvD");
  run(*whole, 0, 7005);
  ASSERT_EQ(whole->call_with(-8, folder.file("monitor.chk")), 0) << whole->message();
  ASSERT_EQ(half->call_with(-9, folder.file("monitor.chk")), 0) << half->message();
  run(*whole, 7005, 12000);
  run(*half, 7005, 12000);
  EXPECT_EQ(results({whole->array.data(), kPrivateArraySize}),
            results({half->array.data(), kPrivateArraySize}));
}

// A step does not allocate, with either method of the delay, whatever happens.
TEST(MonitorLibrary, NoAllocation) {
  if (!kCountsAllocations) GTEST_SKIP() << "malloc belongs to the sanitizer";
  const TempFolder folder;
  const Turbine turbine(6);
  for (const std::string method : {"correlation", "moddemeijer"}) {
    const std::string lines = "1 ! MaximumTrim -\n" + method + " ! DelayMethod -\n";
    DisconCaller caller("liblac_monitor", input(folder, lines));
    turbine.fill(caller.swap(), 0);
    ASSERT_EQ(caller.call(0), 0) << caller.message();
    const NoAllocGuard guard;
    for (long n = 1; n < 20000; ++n) {
      turbine.fill(caller.swap(), n, n > 9000 ? 1.5 : 1.0);
      if (n % 5000 < 100) caller.swap().set(Rec::LidarRewsValid, 0.0);
      if (n % 7000 < 100) caller.swap().set(Rec::GeneratorSpeed, std::nan(""));
      caller.call(1);
    }
    const auto allocations = guard.allocations();
    EXPECT_EQ(allocations, 0U);
    EXPECT_LT(caller.swap().get(Rec::MonitorAuthority), 0.1);
  }
}

}  // namespace
}  // namespace lac::test
