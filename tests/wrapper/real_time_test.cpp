// SPDX-License-Identifier: Apache-2.0
// No allocation in a step: neither in the usual one nor in those with something to say.
#include <limits>

#include "wrapper/chain_fixture.hpp"

#include "support/no_alloc_guard.hpp"  // after <cstdlib>

namespace lac::test {
namespace {

/// Calls of a host that allocates nothing itself.
struct QuietHost {
  LacDisconFunction entry;
  std::vector<float>& array;
  std::vector<char> in, out, message;

  int call(int status) {
    int fail = 0;
    array[0] = static_cast<float>(status);
    entry(array.data(), &fail, in.data(), out.data(), message.data());
    return fail;
  }
};

class RealTime : public ChainTest {};

TEST_F(RealTime, StepsDoNotAllocate) {
  if (!kCountsAllocations) GTEST_SKIP() << "malloc cannot be counted here";
  const auto in = write_chain(
      {{"a", "toy_empty", "", ""},
       {"s", "toy_state", "900 ! WarnAtStep -\n", ""},
       {"b", "toy_static", "", ""}},
      "native ! LidarLayout -\noutb ! OutputFormat -\nTorqueDemand LidarRews ! OutputChannels -\n");
  TestHost host = host_for(in);
  ASSERT_EQ(host.call(0), 0) << host.message();
  host.call(1);
  const std::string out = folder.file("case.SrvD");
  QuietHost quiet{master.entry(),
                  host.array,
                  {in.begin(), in.end()},
                  {out.begin(), out.end()},
                  std::vector<char>(1025)};
  quiet.in.push_back('\0');
  quiet.out.push_back('\0');

  NoAllocGuard guard;
  int warnings = 0;
  for (int i = 0; i < 2000; ++i) {
    host.put(1101, 1.0f);
    host.put(1102, i % 20 == 0 ? 1.0f : 0.0f);
    host.put(1108, 10.0f);
    host.set(Rec::RotorSpeed, i == 500 ? std::numeric_limits<float>::quiet_NaN() : 1.2f);
    warnings += quiet.call(1);
  }
  const auto allocations = guard.allocations();
  EXPECT_EQ(allocations, 0U);
  EXPECT_EQ(warnings, 3);  // not finite, finite again, WarnAtStep
}

// The proof above can fail: the same count sees the allocations of a first call.
TEST_F(RealTime, GuardSeesTheLibraries) {
  if (!kCountsAllocations) GTEST_SKIP() << "malloc cannot be counted here";
  TestHost host = host_for(write_chain({{"s", "toy_state", "", ""}}));
  NoAllocGuard guard;
  host.call(0);
  EXPECT_GT(guard.allocations(), 20U);
}

}  // namespace
}  // namespace lac::test
