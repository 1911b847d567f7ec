// SPDX-License-Identifier: Apache-2.0
// The complete chain for eight turbines at once: the demands are, to the last bit, those of each
// turbine on its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cstring>
#include <exception>
#include <filesystem>
#include <thread>

#include "closed_loop/chain_turbine.hpp"
#include "support/temp_folder.hpp"

namespace lac::test {
namespace {

constexpr int kTurbines = 8;
constexpr int kCalls = 4000;  // 50 s

using Demands = std::vector<float>;

pid_t start_process(int turbine, const std::string& folder) {
  std::vector<std::string> words{LAC_TURBINE_ALONE, std::to_string(turbine), std::to_string(kCalls),
                                 folder};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  const int problem =
      posix_spawn(&process, words[0].c_str(), nullptr, nullptr, arguments.data(), environ);
  EXPECT_EQ(problem, 0) << std::strerror(problem);
  return process;
}

Demands read_demands(const TempFolder& folder, int turbine) {
  const std::string bytes = folder.read("T" + std::to_string(turbine) + ".demands");
  Demands demands(bytes.size() / sizeof(float));
  std::memcpy(demands.data(), bytes.data(), demands.size() * sizeof(float));
  return demands;
}

/// Each turbine in a process of its own; flown once for all tests.
const std::vector<Demands>& alone() {
  static const std::vector<Demands> all = [] {
    const TempFolder folder;
    std::vector<pid_t> processes;
    for (int t = 0; t < kTurbines; ++t) processes.push_back(start_process(t, folder.path()));
    std::vector<Demands> demands;
    for (int t = 0; t < kTurbines; ++t) {
      int status = -1;
      waitpid(processes[static_cast<std::size_t>(t)], &status, 0);
      EXPECT_EQ(status, 0) << "turbine " << t;
      demands.push_back(read_demands(folder, t));
    }
    return demands;
  }();
  return all;
}

/// All turbines in this process, each in its own thread, in one copy of the libraries.
std::vector<Demands> together(const TempFolder& folder, bool moving_arrays) {
  const DisconLibrary master = open_master();
  std::vector<Demands> demands(kTurbines);
  std::vector<std::thread> threads;
  for (int t = 0; t < kTurbines; ++t) {
    threads.emplace_back([&, t] {
      try {
        ChainTurbine turbine(master, t, folder.path());
        turbine.moving_array = moving_arrays;
        turbine.run(kCalls);
        demands[static_cast<std::size_t>(t)] = turbine.demands;
      } catch (const std::exception& e) {
        ADD_FAILURE() << "turbine " << t << ": " << e.what();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  return demands;
}

void expect_same_bits(const std::vector<Demands>& found) {
  for (std::size_t t = 0; t < kTurbines; ++t) {
    ASSERT_EQ(alone()[t].size(), 2U * kCalls) << "turbine " << t;
    ASSERT_EQ(found[t].size(), 2U * kCalls) << "turbine " << t;
    EXPECT_EQ(std::memcmp(found[t].data(), alone()[t].data(), found[t].size() * sizeof(float)), 0)
        << "turbine " << t;
  }
}

// Turbines differ from each other, so that a mix-up would be seen.
TEST(ManyTurbines, Differ) {
  for (std::size_t a = 0; a < kTurbines; ++a) {
    ASSERT_EQ(alone()[a].size(), 2U * kCalls) << "turbine " << a;
    for (std::size_t b = 0; b < a; ++b) EXPECT_NE(alone()[a], alone()[b]) << a << ' ' << b;
  }
}

TEST(ManyTurbines, ThreadsEqualProcesses) {
  const TempFolder folder;
  expect_same_bits(together(folder, false));
  for (int t = 0; t < kTurbines; ++t) {
    EXPECT_GT(std::filesystem::file_size(folder.file("T" + std::to_string(t) + ".lac.outb")),
              1000U);
  }
}

// A host whose array lies elsewhere in each call.
TEST(ManyTurbines, MovingArraysEqualProcesses) {
  const TempFolder folder;
  expect_same_bits(together(folder, true));
}

}  // namespace
}  // namespace lac::test
