// SPDX-License-Identifier: Apache-2.0
// A step of the complete chain with lidar does not allocate, lock, or call the operating system.
// The master's own output file, the one exception, is switched off here.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>

#include "closed_loop/chain_inputs.hpp"
#include "support/discon_caller.hpp"
#include "support/temp_folder.hpp"

#include "support/no_alloc_guard.hpp"  // after <cstdlib>
#if !LAC_MALLOC_IS_OUT_OF_REACH
#include "closed_loop/no_lock_guard.hpp"
#endif
#include "closed_loop/no_syscalls.hpp"

namespace lac::test {
namespace {

constexpr int kSteps = 10000;

/// What an input file of ldp may ask for beside the shipped one: everything.
constexpr const char* kAllOfLdp =
    "all ! WindModel\n10 ! ReconstructionWindow\n90 ! HubHeight\n63 ! RotorRadius\n"
    "average ! WhenRefused\n1 1 1 1 1 1 1 1 1 2 ! GateWeights\n"
    "vortex_cylinder ! InductionModel\n5 15 25 ! InductionWindSpeed\n"
    "0.8 0.25 0.05 ! InductionThrust\ntrue ! InductionDelay\n4 ! SpikeLimit\n"
    "turbine ! TravelSpeed\n1 ! BridgeGaps\n0.9 ! AvailabilityLimit\n40 ! MinimumRange\n";

/// The parameter is added to the input file of ldp.
class RealTime : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!kCountsAllocations) GTEST_SKIP() << "malloc, locks and memory belong to the sanitizer";
    run(0);
    run(1);
    ASSERT_EQ(failures, 0) << host.message();
  }

  /// wrapper_monitor.IN without output file.
  std::string chain() const {
    const std::string shipped = LAC_SOURCE_DIR "/config/nrel5mw/";
    const std::string ldp = folder.write("ldp.IN", folder.read(shipped + "ldp.IN") + GetParam());
    return folder.write(
        "chain.IN", "ldp liblac_ldp " + ldp + " ! Secondary_1 -\n" +
                        "ti_estimator liblac_ti_estimator " + shipped +
                        "ti_estimator.IN ! Secondary_2 -\n" + "monitor liblac_monitor " + shipped +
                        "monitor.IN ! Secondary_3 -\n" + "ffp liblac_ffp " + shipped +
                        "ffp_monitor.IN ! Secondary_4 -\n" + "feedback liblac_feedback " + shipped +
                        "feedback_lac.IN ! Secondary_5 -\n" + "native ! LidarLayout -\n");
  }

  void run(int status, bool measured_good = true) {
    inputs.fill(host.swap());
    if (!measured_good) host.swap().set(Rec::GeneratorSpeed, std::nan(""));
    const int fail = host.call(status);
    if (fail < 0) failures += 1;
    if (fail > 0) warnings += 1;
  }

  /// Everything that happens in a life: feedforward comes, the lidar dies and comes back, a
  /// measured record is not a number for a while.
  void live() {
    for (int i = 0; i < kSteps; ++i) {
      inputs.lidar_alive = i < 6000 || i > 8000;
      run(1, i < 4000 || i > 4010);
      if (host.swap().get(Rec::PitchDemandCollective) != last_pitch_rad) changes += 1;
      last_pitch_rad = host.swap().get(Rec::PitchDemandCollective);
    }
  }

  TempFolder folder;
  ChainInputs inputs{0};
  DisconCaller host{"liblac_wrapper", chain(), kExtendedArraySize, folder.file("run.SrvD")};
  double last_pitch_rad = 0.0;
  int failures = 0, warnings = 0, changes = 0;
};

TEST_P(RealTime, NoAllocation) {
  const NoAllocGuard guard;
  live();
  const auto allocations = guard.allocations();
  EXPECT_EQ(allocations, 0U);
  EXPECT_EQ(failures, 0);
  EXPECT_GE(warnings, 3);          // not a number, good again, the dead lidar
  EXPECT_GT(changes, kSteps / 2);  // the chain is at work
}

#if !LAC_MALLOC_IS_OUT_OF_REACH
TEST_P(RealTime, NoLock) {
  const auto before = locks_of_thread;
  live();
  EXPECT_EQ(locks_of_thread, before);
  EXPECT_EQ(failures, 0);
}

// The two counts above can fail: the first call of a second turbine allocates and locks.
TEST_P(RealTime, GuardsSeeTheLibraries) {
  const std::string in_file = chain();
  DisconCaller other("liblac_wrapper", in_file, kExtendedArraySize, folder.file("other.SrvD"));
  inputs.fill(other.swap());
  const NoAllocGuard guard;
  const auto locks = locks_of_thread;
  ASSERT_EQ(other.call(0), 0) << other.message();
  EXPECT_GT(guard.allocations(), 100U);
  EXPECT_GT(locks_of_thread, locks + 5);  // six libraries enter an instance each
}
#endif

// No system call means no file, no clock of the kernel, no waiting for a lock.
TEST_P(RealTime, NoSystemCall) {
  const int status = wait_status_without_system_calls([&] {
    live();
    return failures == 0 ? 0 : 1;
  });
  ASSERT_NE(status, kNoFilter << 8) << "the kernel allows no filter of system calls here";
  EXPECT_EQ(status, 0);
}

// The filter sees what it is for: the last call, which is no step, unloads libraries.
TEST_P(RealTime, FilterSeesSystemCalls) {
  const int status = wait_status_without_system_calls([&] { return host.call(-1); });
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS) << status;
}

INSTANTIATE_TEST_SUITE_P(Ldp, RealTime, testing::Values("", kAllOfLdp),
                         [](const auto& p) { return *p.param == '\0' ? "shipped" : "all"; });

}  // namespace
}  // namespace lac::test
