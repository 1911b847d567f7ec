// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/parallel_jobs.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/error.hpp"

namespace lac::sim {
namespace {

// Every job is done once, whatever the number of threads.
TEST(ParallelJobs, EachOnce) {
  for (const int threads : {1, 3}) {
    std::vector<std::atomic<int>> done(100);
    for_each_job(100, threads, [&] { return [&](int job) { ++done[job]; }; });
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1) << threads;
  }
}

// When a job has thrown, the other thread finishes what it is at and takes no further ones.
TEST(ParallelJobs, StopsAfterAFault) {
  constexpr int kJobs = 400;
  std::atomic<bool> thrown{false};
  std::atomic<int> done{0};
  const auto job = [&](int number) {
    if (number == 0) {
      thrown = true;
      throw Error("first job");
    }
    while (!thrown) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ++done;
  };
  EXPECT_THROW(for_each_job(kJobs, 2, [&] { return job; }), Error);
  EXPECT_LT(done, kJobs / 2);
}

}  // namespace
}  // namespace lac::sim
