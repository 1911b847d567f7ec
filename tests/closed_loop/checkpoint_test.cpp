// SPDX-License-Identifier: Apache-2.0
// Checkpoint and restart through the complete chain, in freshly loaded libraries.
#include <gtest/gtest.h>

#include <optional>

#include "closed_loop/chain_turbine.hpp"
#include "support/temp_folder.hpp"

namespace lac::test {
namespace {

constexpr int kTurbine = 3;
constexpr int kBefore = 3333;  // 42 s, in the middle of a scan
constexpr int kAfter = 3000;

// The demands behind the restart are those of a run that was never interrupted, to the last bit.
TEST(Checkpoint, ContinuesExactly) {
  const TempFolder folder;
  const std::string file = folder.file("run.3333.dll.chkp");
  std::vector<float> whole, halves;
  {
    const DisconLibrary master = open_master();
    ChainTurbine turbine(master, kTurbine, folder.path());
    turbine.run(kBefore + kAfter);
    whole = turbine.demands;
  }
  std::optional<DisconLibrary> master(open_master());
  std::optional<ChainTurbine> first(std::in_place, *master, kTurbine, folder.path());
  first->run(kBefore);
  ASSERT_EQ(first->host.call_with(-8, file), 0) << first->host.message();
  halves = first->demands;
  first.reset();
  master.reset();

  master.emplace(open_master());
  ChainTurbine second(*master, kTurbine, folder.path());
  second.inputs.skip(kBefore);
  ASSERT_EQ(second.restart(file), 0) << second.host.message();
  second.run(kAfter);
  halves.insert(halves.end(), second.demands.begin(), second.demands.end());
  ASSERT_EQ(whole.size(), halves.size());
  const auto [a, b] = std::mismatch(whole.begin(), whole.end(), halves.begin());
  EXPECT_TRUE(a == whole.end()) << "call " << (a - whole.begin()) / 2 << ": " << *a << " and "
                                << *b;
}

}  // namespace
}  // namespace lac::test
