// SPDX-License-Identifier: Apache-2.0
// lac wind: making, converting, statistics and checks as a user meets them.
#include "sim_harness/cli/wind_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "sim_harness/tables/outb_reader.hpp"
#include "sim_harness/wind/bladed_file.hpp"
#include "sim_harness/wind/bts_file.hpp"
#include "sim_harness/wind/uniform_file.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class WindCommandTest : public testing::Test {
 protected:
  WindCommandTest() {
    folder_.write("kaimal.yaml",
                  "hub_height_m: 90\nrotor_radius_m: 63\nseed: 3\n"
                  "wind: {kind: kaimal, mean_speed_mps: 12, points_across: 9, points_up: 9, "
                  "time_step_s: 0.5, period_s: 256, threads: 1}\n");
    folder_.write("ews.yaml",
                  "hub_height_m: 90\nrotor_radius_m: 63\n"
                  "wind: {kind: ews, mean_speed_mps: 12, start_s: 4, shear_exponent: 0.2}\n");
  }

  std::string file(const std::string& name) const { return folder_.file(name); }
  std::string convert(const std::string& from, const std::string& to, WindFileOptions options = {},
                      WindSamplingOptions sampling = {}) {
    std::ostringstream out;
    wind_convert_command({file(from), file(to), std::move(options), sampling}, out);
    return out.str();
  }
  template <class Action>
  static std::string error(Action&& action) {
    return lac::test::error_text(std::forward<Action>(action));
  }

  lac::test::TempFolder folder_;
};

// A case's turbulence as .bts, .wnd and a box, back and forth: the numbers stay, and what is said
// of the box is what reads it.
TEST_F(WindCommandTest, GriddedFormats) {
  EXPECT_THAT(convert("kaimal.yaml", "a.bts"),
              HasSubstr("a.bts: 512 x 9 x 9 points, 0.5 s, 17.5 m, 17.5 m apart, 20 to 160 m above "
                        "ground, mean speed 12 m/s, periodic\n"));
  convert("a.bts", "b.wnd");
  const std::string said = convert("b.wnd", "c.bin");
  EXPECT_THAT(said, HasSubstr("--points 512 9 9 --spacing 6 17.5 17.5 --mean-speed 12 "
                              "--hub-height 90\n"));
  WindFileOptions box;
  box.points = {512, 9, 9};
  box.spacing_m = {6.0, 17.5, 17.5};
  box.mean_speed_mps = 12.0;
  box.hub_height_m = 90.0;
  convert("c-u.bin", "d.bts", box);
  const GriddedWind first = read_bts(file("a.bts")), last = read_bts(file("d.bts"));
  for (int it = 0; it < 512; it += 37) {
    for (int i = 0; i < 243; ++i)
      EXPECT_NEAR(first.grid().plane(it)[i], last.grid().plane(it)[i], 2e-3);
  }
}

// Overrides reach the case; another seed is another field.
TEST_F(WindCommandTest, Overrides) {
  convert("kaimal.yaml", "a.bts");
  WindFileOptions options;
  options.overrides = {"seed=4"};
  convert("kaimal.yaml", "b.bts", options);
  EXPECT_NE(folder_.read("a.bts"), folder_.read("b.bts"));
  options.overrides = {"sed=4"};
  EXPECT_THAT(error([&] { convert("kaimal.yaml", "b.bts", options); }),
              HasSubstr("sed: unknown key (did you mean 'seed'?)"));
}

// A uniform wind becomes rows, also under the name .wnd; on a grid it becomes numbers.
TEST_F(WindCommandTest, UniformWind) {
  const std::string said = convert("ews.yaml", "a.wnd");
  EXPECT_THAT(said, HasSubstr("--hub-height 90 --rotor-diameter 126"));
  const UniformTable table = read_uniform_file(file("a.wnd"));
  EXPECT_EQ(table.rows.back().time_s, 600.0);
  EXPECT_EQ(table.rows[0].state.shear_exponent, 0.2);
  WindFileOptions uniform;
  uniform.hub_height_m = 90.0;
  uniform.rotor_diameter_m = 126.0;
  WindSamplingOptions grid;
  grid.points_across = grid.points_up = 5;
  grid.width_m = grid.height_m = 126.0;
  grid.duration_s = 20.0;
  grid.time_step_s = 0.5;
  convert("a.wnd", "b.bts", uniform, grid);
  const GriddedWind wind = read_bts(file("b.bts"));
  EXPECT_EQ(wind.grid().spec().nt, 41);
  const double rim_mps = 12.0 * std::pow(153.0 / 90.0, 0.2);
  EXPECT_NEAR(wind.velocity({0.0, 0.0, 153.0}, 0.0).x, rim_mps, 1e-3);
  EXPECT_GT(wind.velocity({0.0, 0.0, 153.0}, 10.0).x, rim_mps + 6.0);
  convert("a.wnd", "c.wnd", uniform, grid);
  EXPECT_EQ(read_bladed(file("c.wnd")).grid().spec().nt, 41);
}

// What cannot be: each with the file and what is missing.
TEST_F(WindCommandTest, ConvertFaults) {
  convert("kaimal.yaml", "a.bts");
  convert("ews.yaml", "a.hh");
  EXPECT_THAT(error([&] { convert("a.bts", "b.hh"); }),
              HasSubstr("b.hh: a uniform wind file holds one state at a time; a.bts has more"));
  EXPECT_THAT(error([&] { convert("a.hh", "b.bts"); }),
              HasSubstr("a.hh: the file does not say its height; give --hub-height"));
  EXPECT_THAT(error([&] { convert("ews.yaml", "b.bts"); }),
              HasSubstr("b.bts: this wind has no grid of its own; give --grid"));
  EXPECT_THAT(error([&] { convert("a.bts", "b.txt"); }), HasSubstr("found the ending '.txt'"));
  EXPECT_THAT(error([&] { convert("a.bts", "b.yaml"); }), HasSubstr("is the name of a case file"));
  folder_.write("x-u.bin", "1234");
  EXPECT_THAT(error([&] { convert("x-u.bin", "b.bts"); }),
              HasSubstr("how many points it has; give --points NX NY NZ"));
  EXPECT_FALSE(std::filesystem::exists(file("b.bts")));
}

// Statistics of a file, and its channels.
TEST_F(WindCommandTest, Statistics) {
  convert("kaimal.yaml", "a.bts");
  std::ostringstream out;
  WindStatsOptions options;
  options.input = file("a.bts");
  options.window_s = 120.0;
  options.channels = file("a.outb");
  wind_stats_command(options, out);
  EXPECT_THAT(out.str(), ContainsRegex("hub u +m/s +12.000 "));
  EXPECT_THAT(out.str(), HasSubstr("windows of 120.0 s; 49 points within 70.0 m about 90.0 m"));
  const Recording channels = read_outb(file("a.outb"));
  EXPECT_EQ(channels.rows(), 512U);
  EXPECT_NEAR(channels.column("RtVAvgxh")[100], 12.0, 5.0);
}

// A case is its own theory; a file is checked against that case, and fails against another one; the
// page is written either way.
TEST_F(WindCommandTest, Check) {
  std::ostringstream out;
  WindCheckOptions options;
  options.input = file("kaimal.yaml");
  EXPECT_TRUE(wind_check_command(options, out));
  EXPECT_THAT(out.str(), HasSubstr("against Kaimal, v and w independent"));
  convert("kaimal.yaml", "a.wnd");
  options.input = file("a.wnd");
  EXPECT_THAT(error([&] { wind_check_command(options, out); }),
              HasSubstr("a file does not say what theory it is of; give --theory-case"));
  options.theory_case = file("kaimal.yaml");
  EXPECT_TRUE(wind_check_command(options, out));
  options.theory_case.clear();
  options.theory = "kaimal";
  options.sigma_u_mps = 3.0;
  options.page = file("a.html");
  EXPECT_FALSE(wind_check_command(options, out));
  EXPECT_THAT(out.str(), HasSubstr("outside: spectrum of u at"));
  EXPECT_THAT(folder_.read("a.html"), HasSubstr("Root coherence of u"));
}

// No theory: uniform wind, numbers missing, a turned wind.
TEST_F(WindCommandTest, CheckFaults) {
  std::ostringstream out;
  WindCheckOptions options;
  options.input = file("ews.yaml");
  EXPECT_THAT(error([&] { wind_check_command(options, out); }),
              HasSubstr("expected turbulence on a grid"));
  convert("kaimal.yaml", "a.bts");
  options.input = file("a.bts");
  options.theory = "mann";
  EXPECT_THAT(error([&] { wind_check_command(options, out); }),
              HasSubstr("--theory mann: give --sigma-u"));
  options.theory.clear();
  options.theory_case = file("ews.yaml");
  EXPECT_THAT(error([&] { wind_check_command(options, out); }),
              HasSubstr("expected a wind section of kind kaimal or mann"));
  options.theory_case = file("kaimal.yaml");
  options.file.overrides = {"wind.yaw_deg=5"};
  EXPECT_THAT(error([&] { wind_check_command(options, out); }), HasSubstr("without yaw_deg"));
}

}  // namespace
}  // namespace lac::sim
