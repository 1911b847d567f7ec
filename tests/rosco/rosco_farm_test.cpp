// SPDX-License-Identifier: Apache-2.0
// An unmodified ROSCO, which has one set of variables per image, as feedback secondary of eight
// turbines in one process: the demands are, to the last bit, those of eight processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <iostream>
#include <thread>

#include "closed_loop/chain_turbine.hpp"
#include "rosco/rosco_files.hpp"
#include "support/environment.hpp"
#include "support/growth.hpp"
#include "support/library_names.hpp"

namespace lac::test {
namespace {

constexpr int kTurbines = 8;
constexpr int kCalls = 1200;  // 15 s

using Demands = std::vector<float>;

/// ROSCO behind the master for one turbine, with inputs of its own.
class RoscoTurbine {
 public:
  RoscoTurbine(const DisconLibrary& master, const std::string& in_file, int turbine,
               const std::string& folder)
      : inputs_(turbine),
        host_(master.entry(), in_file, folder + "/T" + std::to_string(turbine) + ".SrvD") {}

  void step() {
    inputs_.fill({host_.array.data(), static_cast<int>(host_.array.size())});
    const int fail = host_.call(std::exchange(status_, 1));
    if (fail != 0) throw std::runtime_error(host_.message());
    demands.insert(demands.end(), host_.array.begin() + 41, host_.array.begin() + 48);  // 42-48
  }
  void run() {
    for (int i = 0; i < kCalls; ++i) step();
    if (host_.call(-1) != 0) throw std::runtime_error(host_.message());
  }

  Demands demands;

 private:
  ChainInputs inputs_;
  TestHost host_;
  int status_ = 0;
};

/// What ROSCO prints at each start would bury the results.
class Silence {
 public:
  Silence() { testing::internal::CaptureStdout(); }
  ~Silence() {
    const std::string told = testing::internal::GetCapturedStdout();
    if (testing::Test::HasFailure()) std::cout << told;
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
};

/// A log without its first line, which has the date.
std::string table_in(const std::string& log) {
  return log.substr(std::min(log.find('\n'), log.size()));
}

class RoscoFarm : public testing::Test {
 protected:
  void SetUp() override {
    if (!rosco.there()) {
      GTEST_SKIP() << rosco.library << " is not there: the rosco wheel was not downloaded";
    }
    rosco.copy_input_to(folder);
    in_file = folder.write("wrapper.IN", "rosco \"" + rosco.library.string() +
                                             "\" DISCON.IN ! Secondary_1 - unmodified\n");
  }
  DisconLibrary open_wrapper() const {
    return DisconLibrary::open(built_library("wrapper"), "DISCON", {});
  }

  /// ROSCO's own log, "<root>.RO.dbg".
  void switch_log_on() const {
    std::string text = folder.read("DISCON.IN");
    const std::string off = "0 ! LoggingLevel";
    ASSERT_NE(text.find(off), std::string::npos);
    folder.write("DISCON.IN", text.replace(text.find(off), off.size(), "1 ! LoggingLevel"));
  }

  /// Flies a turbine in a process of its own, which has never loaded ROSCO; leaves the demands in
  /// <target>/T<turbine>.demands.
  pid_t start_process(int turbine, const TempFolder& target) const {
    const pid_t child = fork();
    if (child != 0) return child;
    int result = 1;
    try {
      const DisconLibrary master = open_wrapper();
      RoscoTurbine one(master, in_file, turbine, target.path().string());
      one.run();
      target.write("T" + std::to_string(turbine) + ".demands",
                   std::string(reinterpret_cast<const char*>(one.demands.data()),
                               one.demands.size() * sizeof(float)));
      result = 0;
    } catch (const std::exception& e) {
      std::fprintf(stderr, "turbine %d: %s\n", turbine, e.what());
    }
    std::fflush(nullptr);
    _exit(result);
  }

  std::vector<Demands> in_processes(const TempFolder& target) const {
    std::vector<pid_t> children;
    for (int t = 0; t < kTurbines; ++t) children.push_back(start_process(t, target));
    std::vector<Demands> all;
    for (int t = 0; t < kTurbines; ++t) {
      int status = -1;
      waitpid(children[static_cast<std::size_t>(t)], &status, 0);
      EXPECT_EQ(status, 0) << "turbine " << t;
      const std::string bytes = target.read("T" + std::to_string(t) + ".demands");
      all.emplace_back(bytes.size() / sizeof(float));
      std::memcpy(all.back().data(), bytes.data(), all.back().size() * sizeof(float));
    }
    return all;
  }

  static void expect_same_bits(const std::vector<Demands>& a, const std::vector<Demands>& b) {
    for (std::size_t t = 0; t < kTurbines; ++t) {
      ASSERT_EQ(a[t].size(), 7U * kCalls) << "turbine " << t;
      ASSERT_EQ(b[t].size(), 7U * kCalls) << "turbine " << t;
      EXPECT_EQ(std::memcmp(a[t].data(), b[t].data(), a[t].size() * sizeof(float)), 0)
          << "turbine " << t;
    }
  }

  TempFolder folder;
  RoscoFiles rosco;
  std::string in_file;
};

// Step by step in turn in one thread. The turbines differ, so that a mix-up would be seen, and
// nothing lies in the temporary folder while they run.
TEST_F(RoscoFarm, InTurnEqualsProcesses) {
  const Silence silence;
  const TempFolder apart, temporary;
  const std::vector<Demands> alone = in_processes(apart);
  for (std::size_t t = 1; t < kTurbines; ++t) EXPECT_NE(alone[t], alone[t - 1]);

  const OtherTemporaryFolder here(temporary.path());
  const DisconLibrary master = open_wrapper();
  std::vector<std::unique_ptr<RoscoTurbine>> farm;
  for (int t = 0; t < kTurbines; ++t) {
    farm.push_back(std::make_unique<RoscoTurbine>(master, in_file, t, folder.path().string()));
  }
  for (int i = 0; i < kCalls; ++i) {
    for (const auto& turbine : farm) turbine->step();
  }
  EXPECT_TRUE(std::filesystem::is_empty(temporary.path()));
  std::vector<Demands> together;
  for (const auto& turbine : farm) together.push_back(turbine->demands);
  expect_same_bits(together, alone);
}

// In eight threads that start at once, each turbine with ROSCO's log switched on: the logs are
// those of the processes as well.
TEST_F(RoscoFarm, InThreadsEqualsProcesses) {
  const Silence silence;
  switch_log_on();
  const TempFolder apart;
  const std::vector<Demands> alone = in_processes(apart);
  const DisconLibrary master = open_wrapper();
  std::vector<Demands> together(kTurbines);
  std::vector<std::thread> threads;
  for (int t = 0; t < kTurbines; ++t) {
    threads.emplace_back([&, t] {
      try {
        RoscoTurbine turbine(master, in_file, t, folder.path().string());
        turbine.run();
        together[static_cast<std::size_t>(t)] = turbine.demands;
      } catch (const std::exception& e) {
        ADD_FAILURE() << "turbine " << t << ": " << e.what();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  expect_same_bits(together, alone);
  for (int t = 0; t < kTurbines; ++t) {
    const std::string log = "T" + std::to_string(t) + ".rosco.RO.dbg";
    EXPECT_GT(table_in(apart.read(log)).size(), 100000U);
    EXPECT_EQ(table_in(folder.read(log)), table_in(apart.read(log))) << log;
  }
}

// Many more at once than a process has link namespaces (11 copies of ROSCO by dlmopen).
TEST_F(RoscoFarm, ThirtyAtOnce) {
  const Silence silence;
  const DisconLibrary master = open_wrapper();
  std::vector<std::unique_ptr<RoscoTurbine>> farm;
  for (int t = 0; t < 30; ++t) {
    farm.push_back(std::make_unique<RoscoTurbine>(master, in_file, t, folder.path().string()));
    farm.back()->step();
  }
  for (const auto& turbine : farm) turbine->step();
}

// Run after run in one process: ROSCO never finds itself "already loaded". It does not free what it
// allocated, 29 KiB a run, whoever loads it; behind the master it is no more than that.
TEST_F(RoscoFarm, RunsDoNotGrow) {
  constexpr int kDirect = 30, kBehindMaster = 100;
  Holdings direct, behind_master;
  {
    const Silence silence;
    direct = growth_of(kDirect, [&] {
      const DisconLibrary own = DisconLibrary::open(rosco.library.string(), "DISCON", {});
      RoscoTurbine(own, folder.file("DISCON.IN"), 0, folder.path().string()).step();
    });
    const DisconLibrary master = open_wrapper();
    behind_master = growth_of(
        kBehindMaster, [&] { RoscoTurbine(master, in_file, 0, folder.path().string()).step(); });
  }
  const double by_itself_kib = direct.heap_kib / kDirect;
  const double behind_kib = behind_master.heap_kib / kBehindMaster;
  std::cout << "not freed by a run: " << by_itself_kib << " KiB of ROSCO by itself, " << behind_kib
            << " KiB behind the master\n";
  EXPECT_EQ(behind_master.libraries, 0);
  EXPECT_EQ(behind_master.files, 0);
  EXPECT_LE(behind_master.mappings, 0);
  EXPECT_NEAR(behind_kib, by_itself_kib, 0.25);
}

}  // namespace
}  // namespace lac::test
