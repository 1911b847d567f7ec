// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/chain_observation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/swap_view.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

class ChainObservationTest : public ::testing::Test {
 protected:
  std::vector<SecondaryAccess> observe(const std::string& script, HostLidar lidar) {
    WrapperParams chain;
    chain.file = folder_.file("chain.IN");
    chain.lidar = lidar;
    chain.secondaries.push_back({"row 1", "toy", LAC_TOY_DIR "/libtoy_script.so",
                                 folder_.write("toy.IN", script), "DISCON"});
    std::vector<float> host(kExtendedArraySize, 0.0F);
    SwapView swap(host.data(), kExtendedArraySize);
    swap.set(Rec::TimeStep, 0.0125);
    swap.set(Rec::ExtendedStart, kExtendedSignature);
    swap.set(Rec::ArraySize, kExtendedArraySize);
    return observe_chain(chain, folder_.path(), std::move(host), folder_.file("out.SrvD"));
  }

  test::TempFolder folder_;
};

// The records are those of the array the master gives, its guards left out.
TEST_F(ChainObservationTest, CountsRecordsAsTheMasterDoes) {
  const auto all = observe("add 3340 20 0\ncount 3712\n", HostLidar::None);
  EXPECT_EQ(all.at(0).problem, "");
  std::vector<int> read, written;
  for (int r = 1; r <= kPrivateArraySize; ++r) {
    if (all[0].accesses.read[static_cast<std::size_t>(r)]) read.push_back(r);
    if (all[0].accesses.written[static_cast<std::size_t>(r)]) written.push_back(r);
  }
  EXPECT_THAT(written, ::testing::ElementsAre(3340, 3712));
  if (!ObservedArray::available()) return;
  EXPECT_THAT(read, ::testing::ElementsAre(20, 3712));
}

// What the master catches is caught: exceptions, writing behind the array.
TEST_F(ChainObservationTest, CatchesWhatTheMasterCatches) {
  EXPECT_EQ(observe("throw\n", HostLidar::None).at(0).problem, "the library threw a C++ exception");
  EXPECT_EQ(observe("above\n", HostLidar::None).at(0).problem,
            "the library wrote outside of the swap array");
}

// In Guo's layout record 63 leads to a block with gates and there is no logging (record 62).
TEST_F(ChainObservationTest, GivesGuoBlock) {
  const std::string script =
      "warn_at 167 10 10 x\nwarn_at 62 0 0 y\necho " + folder_.file("echo.txt") + "\n";
  EXPECT_EQ(observe(script, HostLidar::Guo).at(0).problem, "");
  EXPECT_THAT(folder_.read("echo.txt"), ::testing::HasSubstr(" 62=0 63=165 64=0 "));
}

}  // namespace
}  // namespace lac::sim
