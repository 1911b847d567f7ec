// SPDX-License-Identifier: Apache-2.0
#include "core/rotor_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/rotor_aero.hpp"
#include "core/units.hpp"
#include "support/error_text.hpp"

namespace lac {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const char* const kSmallFile =
    "# ----- Rotor performance tables of a test: power, thrust -----\n"
    "# written by hand\n"
    "\n"
    "# Pitch angle vector, 3 entries - x axis (matrix columns) (deg)\n"
    "-1.0   0.0   +2.0\n"
    "# TSR vector, 2 entries - y axis (matrix rows) (-)\n"
    "6 8\n"
    "# Wind speed vector - z axis (m/s)\n"
    "11.4\n"
    "\n"
    "# Power coefficient\n"
    "\n"
    "0.30 0.40 0.20\n"
    "0.10 0.44 -0.20\n"
    "\n\n"
    "#  Thrust coefficient\n"
    "\n"
    "0.7 0.8 0.6\n"
    "0.9 1.0 0.5\n"
    "\n\n"
    "# Torque coefficient\n"
    "\n"
    "0.05 0.0667 0.0333\n"
    "0.0125 0.055 -0.025\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string error_of(const std::string& text) {
  return test::error_text([&] { RotorTable::parse(text, "cp.txt"); });
}

/// c_P of the planes a + b lambda + c theta + d lambda theta, which bilinear interpolation meets.
RotorTable bilinear_table(const std::vector<double>& tsr, const std::vector<double>& pitch_rad) {
  std::vector<double> cp;
  std::vector<double> ct;
  for (const double l : tsr) {
    for (const double p : pitch_rad) {
      cp.push_back(0.3 + 0.02 * l - 0.5 * p + 0.04 * l * p);
      ct.push_back(0.9 - 0.01 * l + p);
    }
  }
  return {tsr, pitch_rad, cp, ct};
}

// Vectors, units and the place of every number in the file.
TEST(RotorTable, ReadsRoscoLayout) {
  const RotorTable table = RotorTable::parse(kSmallFile, "cp.txt");
  EXPECT_THAT(table.tsr(), testing::ElementsAre(6.0, 8.0));
  EXPECT_THAT(table.pitch_rad(), testing::ElementsAre(rad_from_deg(-1.0), 0.0, rad_from_deg(2.0)));
  EXPECT_DOUBLE_EQ(table.cp(6.0, rad_from_deg(2.0)), 0.20);
  EXPECT_DOUBLE_EQ(table.cp(8.0, rad_from_deg(-1.0)), 0.10);
  EXPECT_DOUBLE_EQ(table.ct(8.0, rad_from_deg(2.0)), 0.5);
}

// Windows line ends and a file without the torque block change nothing.
TEST(RotorTable, AcceptsWindowsLineEndsAndNoTorqueBlock) {
  std::string text(kSmallFile);
  text.erase(text.find("# Torque coefficient"));
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const RotorTable table = RotorTable::parse(windows, "cp.txt");
  EXPECT_DOUBLE_EQ(table.cp(8.0, 0.0), 0.44);
}

// Uniform and irregular grids give the exact value of a function that is linear in each argument.
TEST(RotorTable, InterpolatesBilinearFunctionExactly) {
  const std::vector<double> uniform_tsr = {2.0, 2.5, 3.0, 3.5, 4.0};
  const std::vector<double> irregular_tsr = {2.0, 2.1, 3.3, 3.4, 4.0};
  const std::vector<double> uniform_pitch = {-0.1, 0.0, 0.1, 0.2};
  const std::vector<double> irregular_pitch = {-0.1, 0.01, 0.02, 0.2};
  for (const auto& table : {bilinear_table(uniform_tsr, uniform_pitch),
                            bilinear_table(irregular_tsr, irregular_pitch)}) {
    for (double l = 2.0; l <= 4.0; l += 0.037) {
      for (double p = -0.1; p <= 0.2; p += 0.0071) {
        ASSERT_NEAR(table.cp(l, p), 0.3 + 0.02 * l - 0.5 * p + 0.04 * l * p, 1e-14);
        ASSERT_NEAR(table.ct(l, p), 0.9 - 0.01 * l + p, 1e-14);
      }
    }
  }
}

// Outside, the edge value is held and inside() says no; not a number stays not a number.
TEST(RotorTable, ClampsToEdges) {
  const RotorTable table = bilinear_table({2.0, 3.0, 4.0}, {0.0, 0.1});
  EXPECT_DOUBLE_EQ(table.cp(99.0, -5.0), table.cp(4.0, 0.0));
  EXPECT_DOUBLE_EQ(table.cp(-1.0, 0.7), table.cp(2.0, 0.1));
  EXPECT_TRUE(table.inside(4.0, 0.1));
  EXPECT_FALSE(table.inside(4.01, 0.05));
  EXPECT_FALSE(table.inside(3.0, -0.01));
  EXPECT_FALSE(table.inside(NAN, 0.0));
  EXPECT_TRUE(std::isnan(table.cp(NAN, 0.05)));
  EXPECT_TRUE(std::isnan(table.cp(3.0, NAN)));
}

// Slopes of the bilinear function, inside and at the edges where the difference is one-sided.
TEST(RotorTable, SlopesMatchBilinearFunction) {
  const RotorTable table = bilinear_table({2.0, 3.0, 4.0, 5.0}, {0.0, 0.1, 0.2});
  for (const double l : {2.0, 2.4, 3.7, 5.0}) {
    for (const double p : {0.0, 0.03, 0.2}) {
      EXPECT_NEAR(table.dcp_dtsr(l, p), 0.02 + 0.04 * p, 1e-13);
      EXPECT_NEAR(table.dcp_dpitch_per_rad(l, p), -0.5 + 0.04 * l, 1e-13);
    }
  }
}

// A paraboloid sampled coarsely gives back its vertex in tip-speed ratio, also at a pitch limit.
TEST(RotorTable, FindsOptimum) {
  const std::vector<double> tsr = {5.0, 6.0, 7.0, 8.0, 9.0};
  const std::vector<double> pitch = {-0.1, 0.0, 0.1};
  std::vector<double> cp;
  for (const double l : tsr) {
    for (const double p : pitch) cp.push_back(0.48 - 0.01 * (l - 7.3) * (l - 7.3) - p * p);
  }
  const RotorTable table(tsr, pitch, cp, cp);
  EXPECT_NEAR(table.optimum().tsr, 7.3, 1e-12);
  EXPECT_DOUBLE_EQ(table.optimum().pitch_rad, 0.0);
  EXPECT_NEAR(table.optimum().cp, 0.48, 1e-12);
  const RotorTable::Optimum limited = table.optimum(0.05);
  EXPECT_NEAR(limited.tsr, 7.3, 1e-12);
  EXPECT_DOUBLE_EQ(limited.pitch_rad, 0.05);
  EXPECT_NEAR(limited.cp, 0.48 - 0.005, 1e-12);
}

// Each fault of a file is named with file and line, what is there and what should be.
TEST(RotorTable, NamesFaults) {
  const std::string good(kSmallFile);
  EXPECT_THAT(error_of(replaced(good, "0.10 0.44 -0.20", "0.10 zero -0.20")),
              AllOf(HasSubstr("cp.txt:14"), HasSubstr("\"zero\""), HasSubstr("expected a number")));
  EXPECT_THAT(error_of(replaced(good, "0.10 0.44 -0.20", "0.10 nan -0.20")),
              AllOf(HasSubstr("cp.txt:14"), HasSubstr("\"nan\"")));
  EXPECT_THAT(error_of(replaced(good, "0.10 0.44 -0.20", "0.10 0.44")),
              AllOf(HasSubstr("cp.txt:14"), HasSubstr("2 numbers"), HasSubstr("expected 3")));
  EXPECT_THAT(error_of(replaced(good, "0.9 1.0 0.5\n", "")),
              AllOf(HasSubstr("cp.txt:17"), HasSubstr("1 rows"), HasSubstr("expected 2")));
  EXPECT_THAT(error_of(replaced(good, "6 8", "8 6")),
              AllOf(HasSubstr("cp.txt:7"), HasSubstr("TSR"), HasSubstr("does not rise")));
  EXPECT_THAT(error_of(replaced(good, "3 entries", "4 entries")),
              AllOf(HasSubstr("cp.txt:5"), HasSubstr("3 entries"), HasSubstr("expected 4")));
  EXPECT_THAT(error_of(replaced(good, "#  Thrust coefficient", "# Power coefficient")),
              AllOf(HasSubstr("cp.txt:17"), HasSubstr("second time"), HasSubstr("line 11")));
  EXPECT_THAT(error_of(good.substr(0, good.find("#  Thrust"))),
              AllOf(HasSubstr("cp.txt"), HasSubstr("Thrust coefficient")));
  EXPECT_THAT(error_of("5 4 3\n"), AllOf(HasSubstr("cp.txt:1"), HasSubstr("heading")));
  EXPECT_THAT(error_of(""), HasSubstr("Pitch angle vector"));
  EXPECT_THROW(RotorTable::load("/no/such/table.txt"), Error);
}

// Torque times speed is the power coefficient times the power in the wind; thrust likewise.
TEST(RotorAero, LoadsFollowCoefficients) {
  const RotorAero aero{bilinear_table({2.0, 5.0, 9.0}, {0.0, 0.3}), 50.0, 1.2};
  const double wind_mps = 10.0;
  const double rotor_speed_radps = 1.1;  // lambda 5.5
  const double power_W = 0.5 * 1.2 * kPi * 2500.0 * 1000.0;
  const double cp = 0.3 + 0.02 * 5.5 - 0.5 * 0.1 + 0.04 * 5.5 * 0.1;
  EXPECT_NEAR(aero.torque_Nm(wind_mps, rotor_speed_radps, 0.1) * rotor_speed_radps, power_W * cp,
              1e-9 * power_W);
  EXPECT_NEAR(aero.thrust_N(wind_mps, rotor_speed_radps, 0.1),
              power_W / wind_mps * (0.9 - 0.055 + 0.1), 1e-9 * power_W);
}

// No wind, wind from behind and standstill give finite loads.
TEST(RotorAero, StaysFiniteAtTheEdges) {
  const RotorAero aero{bilinear_table({2.0, 5.0, 9.0}, {0.0, 0.3}), 50.0, 1.2};
  EXPECT_EQ(aero.torque_Nm(0.0, 1.0, 0.0), 0.0);
  EXPECT_EQ(aero.thrust_N(-3.0, 1.0, 0.0), 0.0);
  EXPECT_NEAR(aero.torque_Nm(1e-9, 1.0, 0.0), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(aero.torque_Nm(10.0, 0.0, 0.0), aero.torque_Nm(10.0, 2.0 * 10.0 / 50.0, 0.0));
}

// The formulas against differences of the torque itself, on a surface both represent exactly.
TEST(RotorAero, TorqueSlopesMatchDifferences) {
  const RotorAero aero{bilinear_table({2.0, 5.0, 9.0}, {0.0, 0.3}), 50.0, 1.2};
  const double v = 10.0;
  const double w = 1.1;
  const double p = 0.1;
  const RotorAero::TorqueSlopes slopes = aero.torque_slopes(v, w, p);
  const double h = 1e-5;
  EXPECT_NEAR(slopes.per_wind,
              (aero.torque_Nm(v + h, w, p) - aero.torque_Nm(v - h, w, p)) / (2.0 * h),
              1e-6 * std::abs(slopes.per_wind));
  EXPECT_NEAR(slopes.per_rotor_speed,
              (aero.torque_Nm(v, w + h, p) - aero.torque_Nm(v, w - h, p)) / (2.0 * h),
              1e-6 * std::abs(slopes.per_rotor_speed));
  EXPECT_NEAR(slopes.per_pitch,
              (aero.torque_Nm(v, w, p + h) - aero.torque_Nm(v, w, p - h)) / (2.0 * h),
              1e-6 * std::abs(slopes.per_pitch));
}

// The committed tables against published optima at their smallest pitch: NREL 5 MW report, IEA
// 3.4 MW workbook, IEA 15 MW design tip-speed ratio and largest public c_P.
TEST(RotorTable, CommittedTablesMatchPublishedOptima) {
  struct Published {
    const char* turbine;
    double min_pitch_deg;
    double cp;
    double tsr;
  };
  for (const Published& p :
       {Published{"nrel5mw", 0.0, 0.482, 7.55}, Published{"iea3p4mw", 1.2, 0.478, 8.55},
        Published{"iea15mw", 0.0, 0.470, 9.0}}) {
    const RotorTable table = RotorTable::load(std::string(LAC_SOURCE_DIR "/config/turbines/") +
                                              p.turbine + "/cp_ct.txt");
    const RotorTable::Optimum best = table.optimum(rad_from_deg(p.min_pitch_deg));
    EXPECT_NEAR(best.cp, p.cp, 0.02 * p.cp) << p.turbine;
    EXPECT_NEAR(best.tsr, p.tsr, 0.04 * p.tsr) << p.turbine;
  }
}

}  // namespace
}  // namespace lac
