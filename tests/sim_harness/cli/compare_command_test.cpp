// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/compare_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

class CompareCommandTest : public ::testing::Test {
 protected:
  std::string run(std::vector<std::filesystem::path> inputs) {
    options_.inputs = std::move(inputs);
    std::ostringstream out;
    compare_command(options_, out);
    return out.str();
  }
  /// One row per controller and seed.
  std::string campaign(const std::string& name, const std::vector<std::string>& controllers) {
    std::string text = "case,mean_speed_mps,seed,controller,GenPwr_mean [kW]\n";
    for (int seed = 1; seed <= 3; ++seed) {
      for (std::size_t i = 0; i < controllers.size(); ++i) {
        const int power = 4000 + 100 * seed + 10 * static_cast<int>(i) + seed;
        const std::string number = std::to_string(seed);
        text.append("c").append(number).append(",12,").append(number).append(",");
        text.append(controllers[i]).append(",").append(std::to_string(power)).append("\n");
      }
    }
    return folder_.write(name, text);
  }
  test::TempFolder folder_;
  CompareOptions options_;
};

// One table with two controllers: the first is A; or they are named.
TEST_F(CompareCommandTest, OneTable) {
  const std::string file = campaign("t.csv", {"fb", "lac"});
  EXPECT_THAT(run({file}), HasSubstr("from A = fb to B = lac"));
  EXPECT_THAT(run({file}), HasSubstr("GenPwr_mean [kW]: significant at 12 m/s"));
  options_.baseline = "lac";
  options_.against = "fb";
  EXPECT_THAT(run({file}), HasSubstr("from A = lac to B = fb"));
  options_.against = "lac";
  EXPECT_THAT(test::error_text([&] { run({file}); }), HasSubstr("'lac' against itself"));
}

// Two tables, one controller of each; the written table.
TEST_F(CompareCommandTest, TwoTables) {
  options_.csv = folder_.path("c.csv");
  const std::string text = run({campaign("old.csv", {"fb"}), campaign("new.csv", {"fb"})});
  EXPECT_THAT(text, HasSubstr("from A = old fb to B = new fb"));
  EXPECT_THAT(text, HasSubstr("not significant at 95 % at 12 m/s"));
  EXPECT_THAT(folder_.read("c.csv"), HasSubstr("GenPwr_mean,kW,12,3,4202,4202,0,0,0,not signif"));
}

// Two folders of time series, paired by their names.
TEST_F(CompareCommandTest, TwoFolders) {
  for (const char* name : {"a", "b"}) {
    std::filesystem::create_directory(folder_.path(name));
    for (int seed = 1; seed <= 3; ++seed) {
      const int power = 4000 + 10 * seed + (*name == 'b' ? 50 + seed : 0);
      folder_.write(std::string(name) + "/s" + std::to_string(seed) + ".csv",
                    "time,RtVAvgxh [m/s],GenPwr [kW]\n0,12,4000\n1,12," + std::to_string(power) +
                        "\n2,12," + std::to_string(power) + "\n");
    }
  }
  options_.figures.from_s = 1.0;
  options_.comparison.quantities = {"GenPwr_mean"};
  const std::string text = run({folder_.path("a"), folder_.path("b")});
  EXPECT_THAT(text, HasSubstr("12            3"));
  EXPECT_THAT(text, HasSubstr("GenPwr_mean [kW]: significant at 12 m/s"));
}

// Which controllers, and what to give.
TEST_F(CompareCommandTest, Faults) {
  const std::string three = campaign("three.csv", {"fb", "lac", "mpc"});
  EXPECT_THAT(test::error_text([&] { run({three}); }),
              HasSubstr("three.csv: column 'controller' has 3 controllers (fb, lac, mpc), expected "
                        "2; --baseline and --against name them"));
  options_.against = "lca";
  options_.baseline = "fb";
  EXPECT_THAT(test::error_text([&] { run({three}); }),
              HasSubstr("has no 'lca' (did you mean 'lac'?); there are: fb, lac, mpc"));
  EXPECT_THAT(test::error_text([&] { run({folder_.path()}); }), HasSubstr("expected one table"));
}

}  // namespace
}  // namespace lac::sim
