// SPDX-License-Identifier: Apache-2.0
// Checkpoints, sub-steps, many runs, many turbines.
#include <cmath>
#include <fstream>
#include <thread>

#include "wrapper/chain_fixture.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;

class LifeCycle : public ChainTest {
 protected:
  /// Two controllers with state of one library, a third without.
  std::string stateful_chain(const std::string& file = "chain.IN") {
    return write_chain({{"one", "toy_state", "0.25 ! Weight -\n", ""},
                        {"two", "toy_state", "0.5 ! Weight -\n", ""},
                        {"sum", "toy_script", "count 48\ncount 3341\nadd 46 3341 0\n", ""}},
                       "calls 3341 ! Signal_1 -\n", file);
  }
  static void drive(TestHost& host, int from, int to, std::vector<float>* torque = nullptr) {
    for (int i = from; i < to; ++i) {
      host.set(Rec::GeneratorSpeed, 100.0f + 20.0f * std::sin(0.1f * static_cast<float>(i)));
      ASSERT_EQ(host.call(i == 0 ? 0 : 1), 0) << host.message();
      if (torque != nullptr) torque->push_back(host.get(Rec::TorqueDemand));
    }
  }
};

// Stopped after 40 calls and continued from the checkpoint, the run is the same to the last bit.
// Each secondary got a file of its own; those that are not ours got -8 and -9, too.
TEST_F(LifeCycle, RestartContinuesExactly) {
  std::vector<float> whole, halves;
  {
    TestHost host = host_for(stateful_chain());
    drive(host, 0, 80, &whole);
  }
  const std::string file = folder.file("run.40.dll.chkp");
  TestHost first = host_for(stateful_chain());
  drive(first, 0, 40, &halves);
  ASSERT_EQ(first.call_with(-8, file), 0) << first.message();
  first.call(-1);
  TestHost second = host_for(folder.file("chain.IN"));
  ASSERT_EQ(second.call_with(-9, file), 0) << second.message();
  drive(second, 40, 80, &halves);
  EXPECT_EQ(whole, halves);
  EXPECT_EQ(second.get(Rec::YawRateDemand), 80.0f);
  EXPECT_EQ(second.get(Rec::PitchRateDemand), 80.0f);          // by way of a signal
  EXPECT_EQ(second.get(Rec::PitchDemandCollective), 0.9875f);  // 79 steps of 0.0125 s
  for (const char* name : {"", ".1.one", ".2.two"}) {
    EXPECT_TRUE(std::filesystem::exists(file + name)) << name;
  }
  EXPECT_EQ(folder.read("run.40.dll.chkp.3.sum.toy"), "sum -8\nsum -9\n");
}

TEST_F(LifeCycle, RestartFromABadCheckpoint) {
  const auto in = stateful_chain();
  TestHost host = host_for(in);
  EXPECT_EQ(host.call_with(-9, folder.file("no.chkp")), -1);
  EXPECT_THAT(host.message(), HasSubstr("no.chkp: cannot open the checkpoint"));
  drive(host, 0, 3);
  ASSERT_EQ(host.call_with(-8, folder.file("c.chkp")), 0);
  host.call(-1);
  std::filesystem::remove(folder.file("c.chkp.2.two"));
  EXPECT_EQ(host.call_with(-9, folder.file("c.chkp")), -1);
  EXPECT_THAT(host.message(), HasSubstr("two (libtoy_state" LAC_LIBRARY_SUFFIX "): toy_state: "));
  EXPECT_EQ(host.call(1), -1);
  EXPECT_EQ(host.call_with(-8, folder.file("d.chkp")), -1);
  EXPECT_FALSE(std::filesystem::exists(folder.file("d.chkp")));
}

// Two rotors that the host calls with the same names are told; their checkpoints would meet.
TEST_F(LifeCycle, TwoTurbinesWithTheSameNames) {
  const std::string in = write_chain({{"one", "toy_state", "", ""}});
  TestHost a = host_for(in);
  TestHost b = host_for(in);
  ASSERT_EQ(a.call(0), 0);
  EXPECT_EQ(b.call(0), 1);
  EXPECT_THAT(b.message(), HasSubstr("the same input file and root name"));
  EXPECT_EQ(a.call_with(-8, folder.file("c.chkp")), -1);
  EXPECT_THAT(a.message(), HasSubstr("would overwrite each other"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("c.chkp")));
}

// A root name that no buffer of a secondary could hold is refused at the start.
TEST_F(LifeCycle, TooLongARootName) {
  const std::string in = write_chain({{"one", "toy_state", "", ""}});
  TestHost host(master.entry(), in, std::string(14000, 'r'));
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(), HasSubstr("root name of the run is too long"));
}

// -11 keeps and -10 brings back the master and those secondaries that say they can.
TEST_F(LifeCycle, StoreAndRestore) {
  TestHost host = host_for(write_chain({{"one", "toy_state", "", ""}}));
  drive(host, 0, 10);
  ASSERT_EQ(host.call(-11), 0) << host.message();
  std::vector<float> once, again;
  drive(host, 10, 20, &once);
  ASSERT_EQ(host.call(-10), 0) << host.message();
  drive(host, 10, 20, &again);
  EXPECT_EQ(once, again);
}

// Eight turbines in eight threads, each with its own input, equal eight runs one after another.
TEST_F(LifeCycle, EightTurbinesInEightThreads) {
  constexpr int kTurbines = 8, kSteps = 300;
  std::vector<std::string> inputs;
  for (int t = 0; t < kTurbines; ++t) {
    const std::string weight = std::to_string(0.1 + 0.1 * t) + " ! Weight -\n";
    inputs.push_back(
        write_chain({{"one", "toy_state", weight, ""},
                     {"two", "toy_script", "add 46 47 " + std::to_string(t) + "\n", ""},
                     {"three", "toy_state", weight, ""}},
                    "", "t" + std::to_string(t) + ".IN"));
  }
  const auto fly = [&](int t, std::vector<std::vector<float>>& out) {
    TestHost host(master.entry(), inputs[static_cast<std::size_t>(t)],
                  folder.file("T" + std::to_string(t) + ".SrvD"));
    for (int i = 0; i < kSteps; ++i) {
      host.set(Rec::GeneratorSpeed, 100.0f + 20.0f * std::sin(0.1f * static_cast<float>(i + t)));
      if (host.call(i == 0 ? 0 : 1) != 0) return;  // seen as a difference
      auto& mine = out[static_cast<std::size_t>(t)];
      for (const Rec r : {Rec::TorqueDemand, Rec::PitchRateDemand, Rec::PitchDemandCollective}) {
        mine.push_back(host.get(r));
      }
    }
  };
  std::vector<std::vector<float>> alone(kTurbines), together(kTurbines);
  for (int t = 0; t < kTurbines; ++t) fly(t, alone);
  std::vector<std::thread> threads;
  for (int t = 0; t < kTurbines; ++t) threads.emplace_back([&, t] { fly(t, together); });
  for (std::thread& t : threads) t.join();
  for (int t = 0; t < kTurbines; ++t) {
    EXPECT_EQ(alone[static_cast<std::size_t>(t)].size(), 3U * kSteps);
    EXPECT_EQ(alone[static_cast<std::size_t>(t)], together[static_cast<std::size_t>(t)]);
  }
}

// A turbine may be called from another thread in every step.
TEST_F(LifeCycle, EachStepFromAnotherThread) {
  std::vector<float> here, elsewhere;
  {
    TestHost host = host_for(stateful_chain());
    drive(host, 0, 30, &here);
  }
  TestHost host = host_for(stateful_chain());
  for (int i = 0; i < 30; ++i) {
    std::thread([&] { drive(host, i, i + 1, &elsewhere); }).join();
  }
  EXPECT_EQ(here, elsewhere);
}

}  // namespace
}  // namespace lac::test
