// SPDX-License-Identifier: Apache-2.0
// Our master as the library of ROSCO's Python class, which is the poorest host known: emulated
// here, and the class itself in rosco_toolbox_class_test.cpp.
#include "rosco/rosco_toolbox_host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/discon_library.hpp"
#include "rosco/rosco_files.hpp"
#include "support/test_host.hpp"

namespace lac::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kFeedbackChain = LAC_SOURCE_DIR "/config/nrel5mw/wrapper_fb.IN";
constexpr double kTimeStep_s = 0.1;

class RoscoToolbox : public testing::Test {
 protected:
  /// A turbine that speeds up and slows down around rated; inputs do not depend on the demands.
  static RoscoToolboxHost::Turbine turbine(int n) {
    RoscoToolboxHost::Turbine t;
    t.time_s = kTimeStep_s * n;
    t.pitch_rad = 0.2 + 0.02 * std::sin(0.05 * n);
    t.generator_torque_Nm = 43000.0;
    t.generator_speed_radps = 122.9 + 4.0 * std::sin(0.03 * n);
    t.rotor_speed_radps = t.generator_speed_radps / 97.0;
    t.wind_mps = 18.0;
    return t;
  }
  using Demands = std::array<float, 3>;  // all that the class reads
  static Demands demands(const RoscoToolboxHost& host) {
    return {host.at(42), host.at(47), host.at(48)};
  }
  static std::vector<Demands> fly(RoscoToolboxHost& host, int steps) {
    std::vector<Demands> all;
    for (int n = 1; n <= steps; ++n) {
      auto t = turbine(n);
      if (n == steps) t.status = -1;
      host.call_controller(t);
      EXPECT_EQ(host.fail(), 0) << host.message();
      all.push_back(demands(host));
    }
    EXPECT_TRUE(host.kept_to_its_buffers());
    return all;
  }

  DisconLibrary master = DisconLibrary::open("liblac_wrapper", "DISCON", {LAC_LIBRARY_DIR});
  TempFolder folder;
};

// The feedback-only chain: same demands, bit for bit, as for a host that keeps its array.
TEST_F(RoscoToolbox, FeedbackChainWorks) {
  constexpr int kSteps = 600;
  RoscoToolboxHost host(master.entry(), kFeedbackChain, folder.file("sim"));
  ASSERT_EQ(host.fail(), 0) << host.message();
  const std::vector<Demands> all = fly(host, kSteps);

  TestHost reference(master.entry(), kFeedbackChain, folder.file("reference"), 500);
  const auto set = [&](const RoscoToolboxHost::Turbine& t) {
    for (const Rec r : {Rec::PitchBlade1, Rec::PitchBlade2, Rec::PitchBlade3}) {
      reference.set(r, static_cast<float>(t.pitch_rad));
    }
    reference.set(Rec::GeneratorTorque, static_cast<float>(t.generator_torque_Nm));
    reference.set(Rec::GeneratorSpeed, static_cast<float>(t.generator_speed_radps));
    reference.set(Rec::RotorSpeed, static_cast<float>(t.rotor_speed_radps));
  };
  reference.set(Rec::TimeStep, static_cast<float>(kTimeStep_s));
  RoscoToolboxHost::Turbine first;
  first.generator_speed_radps = first.rotor_speed_radps = 1.0;
  set(first);
  reference.call(LAC_STATUS_FIRST);
  for (int n = 1; n < kSteps; ++n) {
    set(turbine(n));
    ASSERT_EQ(reference.call(LAC_STATUS_STEP), 0) << reference.message();
    const Demands expected{reference.at(42), reference.at(47), reference.at(48)};
    ASSERT_EQ(all[static_cast<std::size_t>(n) - 1], expected) << n;
  }
  EXPECT_GT(reference.at(47), 30000.0f);
}

// Lidar chains: refused at the start, with what is missing and why; later calls fail as well.
TEST_F(RoscoToolbox, LidarChainIsRefused) {
  for (const char* layout : {"native", "openfast"}) {
    const std::string chain =
        folder.write("chain.IN", "\"feedback\" \"liblac_feedback\" \"" LAC_SOURCE_DIR
                                 "/config/nrel5mw/feedback.IN\" ! Secondary_1 - \n" +
                                     std::string(layout) + " ! LidarLayout - \n");
    RoscoToolboxHost host(master.entry(), chain, folder.file("sim"));
    EXPECT_EQ(host.fail(), -1);
    EXPECT_THAT(host.message(),
                AllOf(HasSubstr(std::string("LidarLayout ") + layout),
                      HasSubstr("only 164 records of the host's array are known to exist")));
    host.call_controller(turbine(1));
    EXPECT_EQ(host.fail(), -1);
    EXPECT_TRUE(host.kept_to_its_buffers());
  }
}

// A text that is longer than the class allows ends within its 500 characters.
TEST_F(RoscoToolbox, LongMessagesAreCut) {
  const std::string name = "no_" + std::string(600, 'x') + "_such.IN";
  RoscoToolboxHost host(master.entry(), folder.file(name), folder.file("sim"));
  EXPECT_EQ(host.fail(), -1);
  EXPECT_EQ(host.message().size(), 499U);
  EXPECT_TRUE(host.kept_to_its_buffers());
}

// Two objects of the class in one process need names of their own; then they do not meet.
TEST_F(RoscoToolbox, TwoObjects) {
  RoscoToolboxHost alone(master.entry(), kFeedbackChain, folder.file("alone"));
  const std::vector<Demands> expected = fly(alone, 100);
  RoscoToolboxHost a(master.entry(), kFeedbackChain, folder.file("a"));
  RoscoToolboxHost b(master.entry(), kFeedbackChain, folder.file("b"));
  for (int n = 1; n < 100; ++n) {
    a.call_controller(turbine(n));
    EXPECT_EQ(demands(a), expected[static_cast<std::size_t>(n) - 1]);
    b.call_controller(turbine(n + 50));
    EXPECT_EQ(b.fail(), 0) << b.message();
  }
  for (RoscoToolboxHost* host : {&a, &b}) {
    auto last = turbine(100);
    last.status = -1;
    host->call_controller(last);
  }
}

// A run that was not ended and a new one with its name, in an array that moves: warned of, refused.
TEST_F(RoscoToolbox, SameNameTwice) {
  RoscoToolboxHost forgotten(master.entry(), kFeedbackChain, folder.file("a"));
  forgotten.call_controller(turbine(1));
  EXPECT_EQ(forgotten.fail(), 0) << forgotten.message();
  RoscoToolboxHost next(master.entry(), kFeedbackChain, folder.file("a"));
  EXPECT_EQ(next.fail(), 1);
  EXPECT_THAT(next.message(), HasSubstr("has the same input file and root name"));
  next.call_controller(turbine(1));
  EXPECT_EQ(next.fail(), -1);
}

// An unmodified ROSCO behind our master: what the class reads is what it gets without the master.
TEST_F(RoscoToolbox, RoscoBehindTheMaster) {
  const RoscoFiles rosco;
  if (!rosco.there()) {
    GTEST_SKIP() << rosco.library << " is not there: the rosco wheel was not downloaded";
  }
  const std::string input = rosco.copy_input_to(folder);
  const std::string chain =
      folder.write("chain.IN", "rosco \"" + rosco.library.string() +
                                   "\" DISCON.IN ! Secondary_1 - unmodified\n");
  RoscoToolboxHost behind(master.entry(), chain, folder.file("behind"));
  ASSERT_EQ(behind.fail(), 0) << behind.message();
  const std::vector<Demands> got = fly(behind, 300);
  const DisconLibrary direct = DisconLibrary::open(rosco.library.string(), "DISCON", {});
  RoscoToolboxHost alone(direct.entry(), input, folder.file("direct"),
                         RoscoToolboxHost::kFloatsReadByRosco);
  EXPECT_EQ(got, fly(alone, 300));
}

}  // namespace
}  // namespace lac::test
