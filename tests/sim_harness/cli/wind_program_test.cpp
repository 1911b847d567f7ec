// SPDX-License-Identifier: Apache-2.0
// `lac wind` on the command line: options reach the commands, exit codes, hints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "sim_harness/wind/bts_file.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class WindProgramTest : public ::testing::Test {
 protected:
  WindProgramTest() {
    folder_.write("wind.yaml",
                  "hub_height_m: 90\nrotor_radius_m: 63\n"
                  "wind: {kind: kaimal, mean_speed_mps: 12, points_across: 5, points_up: 5, "
                  "time_step_s: 0.5, period_s: 128, threads: 1}\n");
    folder_.write("edc.yaml",
                  "hub_height_m: 90\nrotor_radius_m: 63\n"
                  "wind: {kind: edc, mean_speed_mps: 12, start_s: 4, angle_deg: 30}\n");
  }

  /// The exit code; the texts in out.txt and error.txt.
  int lac(const std::string& arguments) {
    const std::string command = "cd '" + folder_.path().string() +
                                "' && '" LAC_BINARY_DIR "/lac' wind " + arguments +
                                " > out.txt 2> error.txt < /dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string error() const { return folder_.read("error.txt"); }

  lac::test::TempFolder folder_;
};

// make, convert with and without the options of a box, stats: 0.
TEST_F(WindProgramTest, MakeConvertStats) {
  ASSERT_EQ(lac("make wind.yaml -o a.bts --set seed=7"), 0) << error();
  ASSERT_EQ(lac("convert a.bts box.bin --last-plane-first --rows-from-right"), 0) << error();
  EXPECT_THAT(folder_.read("out.txt"), HasSubstr("--last-plane-first --rows-from-right"));
  const std::string box = " --points 256 5 5 --spacing 6 35 35 --mean-speed 12 --hub-height 90";
  ASSERT_EQ(lac("convert box-u.bin b.bts --last-plane-first --rows-from-right" + box), 0);
  ASSERT_EQ(lac("convert box-u.bin c.bts" + box), 0) << error();
  const GriddedWind a = read_bts(folder_.file("a.bts")), b = read_bts(folder_.file("b.bts")),
                    c = read_bts(folder_.file("c.bts"));
  EXPECT_NEAR(a.grid().at(3, 1, 0, 1), b.grid().at(3, 1, 0, 1), 1e-3);
  EXPECT_NEAR(a.grid().at(3, 1, 0, 1), c.grid().at(252, 1, 4, 1), 1e-3);
  EXPECT_EQ(lac("stats a.bts --rotor-diameter 100 --window 60"), 0) << error();
  EXPECT_THAT(folder_.read("out.txt"), HasSubstr("within 50.0 m about 90.0 m"));
}

// --planes: each plane of evolving wind in a file, the rotor's that of the plain make.
TEST_F(WindProgramTest, Planes) {
  const std::string evolving = " --set 'wind.evolution={planes_m: [50, 62.5]}'";
  ASSERT_EQ(lac("make wind.yaml -o all.bts --planes" + evolving), 0) << error();
  EXPECT_THAT(folder_.read("out.txt"), HasSubstr("wrote all_62.5m.bts: 256 x 5 x 5 points"));
  ASSERT_EQ(lac("make wind.yaml -o one.bts" + evolving), 0) << error();
  const auto u = [&](const char* name) {
    return read_bts(folder_.file(name)).grid().at(7, 2, 3, 0);
  };
  EXPECT_EQ(u("all_0m.bts"), u("one.bts"));
  EXPECT_NE(u("all_50m.bts"), u("one.bts"));
  EXPECT_EQ(lac("make wind.yaml -o all.bts --planes"), 1);
  EXPECT_THAT(error(), HasSubstr("expected wind with the key evolution"));
}

// --grid puts a uniform wind on points; 30 deg to the right at the end.
TEST_F(WindProgramTest, Grid) {
  ASSERT_EQ(lac("make edc.yaml -o e.bts --grid 3 4 20 30 --duration 20 --time-step 0.5"), 0);
  const GriddedWind wind = read_bts(folder_.file("e.bts"));
  EXPECT_EQ(wind.grid().spec().ny, 3);
  EXPECT_EQ(wind.grid().spec().nz, 4);
  EXPECT_EQ(wind.grid().spec().nt, 41);
  EXPECT_NEAR(wind.velocity({0.0, 0.0, 90.0}, 20.0).y, -6.0, 1e-3);
}

// A check ends with 0 or 1, like an error; words are put right.
TEST_F(WindProgramTest, ExitCodesAndHints) {
  EXPECT_EQ(lac("check wind.yaml"), 0) << error();
  EXPECT_EQ(lac("check wind.yaml --theory kaimal --sigma-u 4 --html page.html"), 1);
  EXPECT_THAT(folder_.read("out.txt"), HasSubstr("outside"));
  EXPECT_THAT(folder_.read("page.html"), StartsWith("<!DOCTYPE html>"));
  EXPECT_EQ(error(), "");
  EXPECT_EQ(lac("chek wind.yaml"), 1);
  EXPECT_THAT(error(), HasSubstr("lac: unknown command 'chek' (did you mean 'check'?); 'lac wind "
                                 "--help'"));
  EXPECT_EQ(lac("check wind.yaml --theori kaimal"), 1);
  EXPECT_THAT(error(), HasSubstr("unknown option '--theori' (did you mean '--theory'?); 'lac wind "
                                 "check --help'"));
  EXPECT_EQ(lac("make wind.yaml"), 1);
  EXPECT_THAT(error(), HasSubstr("--output is required"));
}

}  // namespace
}  // namespace lac::sim
