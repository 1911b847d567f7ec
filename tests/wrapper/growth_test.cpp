// SPDX-License-Identifier: Apache-2.0
// Many runs one after another in one process leave nothing behind.
#include "support/growth.hpp"

#include "wrapper/chain_fixture.hpp"

namespace lac::test {
namespace {

class Growth : public ChainTest {
 protected:
  /// The shipped lidar-assisted chain and a controller with static data.
  std::string all_libraries() {
    const std::string config = std::string(LAC_SOURCE_DIR) + "/config/nrel5mw/";
    std::string text;
    int n = 0;
    for (const std::string name : {"ldp", "ti_estimator", "monitor", "ffp", "feedback_lac"}) {
      const std::string library = name.substr(0, name.find("_lac"));
      text += name + " " + built_library(library) + " " + config + name + ".IN ! Secondary_" +
              std::to_string(++n) + " -\n";
    }
    folder.write("e.txt", "");
    return folder.write("all.IN", text + "static " + toy("toy_static") +
                                      " e.txt ! Secondary_6 -\n" +
                                      "native ! LidarLayout -\ncsv ! OutputFormat -\n" +
                                      "TorqueDemand LidarRews ! OutputChannels -\n");
  }
};

// All our libraries and one with static data, 1000 runs of three calls.
TEST_F(Growth, ThousandRuns) {
  const std::string in = all_libraries();
  const Holdings grown = growth_of(1000, [&] {
    TestHost host = host_for(in);
    host.put(kNativeLidarBlock.first, native_lidar::kLayoutVersion);
    ASSERT_GE(host.call(0), 0) << host.message();
    ASSERT_GE(host.call(1), 0) << host.message();
    ASSERT_GE(host.call(-1), 0) << host.message();
  });
  expect_no_growth(grown);
}

// The same for 300 runs whose first call fails after libraries were loaded and called.
TEST_F(Growth, FailedStarts) {
  const std::string in = write_chain({{"a", "toy_state", "", ""},
                                      {"b", "toy_static", "", ""},
                                      {"c", "toy_state", "0 ! FailAtStep -\n", ""}});
  const Holdings grown = growth_of(300, [&] {
    TestHost host = host_for(in);
    ASSERT_EQ(host.call(0), -1);
  });
  expect_no_growth(grown);
}

}  // namespace
}  // namespace lac::test
