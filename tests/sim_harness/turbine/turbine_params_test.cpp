// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/turbine_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path kTurbines = LAC_SOURCE_DIR "/config/turbines";

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What load_turbine says when one text of the NREL 5 MW file is replaced by another.
std::string error_with(const std::string& from, const std::string& to) {
  std::string text = file_text(kTurbines / "nrel5mw/turbine.yaml");
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return "not in the file: " + from;
  text.replace(at, from.size(), to);
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "lac_turbine_params";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "turbine.yaml") << text;
  std::ofstream(folder / "cp_ct.txt") << file_text(kTurbines / "nrel5mw/cp_ct.txt");
  std::string message = "no error";
  try {
    load_turbine(folder / "turbine.yaml");
  } catch (const Error& error) {
    message = error.what();
  }
  std::filesystem::remove_all(folder);
  return message;
}

// Units of the file against SI inside, and the derived tower stiffness of the source (1.81e6 N/m).
TEST(TurbineParams, ConvertsUnits) {
  const TurbineParams p = load_turbine(kTurbines / "nrel5mw/turbine.yaml");
  EXPECT_NEAR(p.rated_rotor_speed_radps, 1.26711, 1e-5);
  EXPECT_DOUBLE_EQ(p.rated_power_W, 5e6);
  EXPECT_DOUBLE_EQ(p.rated_torque_Nm, 43093.5);
  EXPECT_DOUBLE_EQ(p.max_pitch_rad, kPi / 2.0);
  EXPECT_NEAR(p.pitch_actuator.rate_limit_radps, 0.13963, 1e-5);
  EXPECT_NEAR(p.tower.stiffness_Npm, 1.81e6, 1e2);
  EXPECT_EQ(p.number_of_blades, 3);
  EXPECT_EQ(p.rotor.radius_m, 63.0);
}

// Each turbine delivers its rated power at rated torque and speed, within 0.1 %.
TEST(TurbineParams, RatedValuesBelongTogether) {
  for (const char* name : {"nrel5mw", "iea3p4mw", "iea15mw"}) {
    const TurbineParams p = load_turbine(kTurbines / name / "turbine.yaml");
    EXPECT_NEAR(
        p.rated_torque_Nm * p.gearbox_ratio * p.rated_rotor_speed_radps * p.generator_efficiency,
        p.rated_power_W, 1e-3 * p.rated_power_W)
        << name;
  }
}

// The region-2 gain of the file is within 4 % of the one its rotor table asks for.
TEST(TurbineParams, RegionTwoGainFitsTable) {
  for (const char* name : {"nrel5mw", "iea3p4mw", "iea15mw"}) {
    const TurbineParams p = load_turbine(kTurbines / name / "turbine.yaml");
    const double ratio_cubed = p.gearbox_ratio * p.gearbox_ratio * p.gearbox_ratio;
    const double from_table = p.rotor.optimal_torque_gain_Nms2prad2(p.fine_pitch_rad) *
                              p.gearbox_efficiency / ratio_cubed;
    EXPECT_NEAR(p.region2_gain_Nms2prad2, from_table, 0.04 * from_table) << name;
  }
}

// Bad files: file, line, key, what was found and what was expected.
TEST(TurbineParams, NamesFaults) {
  EXPECT_THAT(error_with("radius_m: 63.0", "radius: 63.0"),
              AllOf(HasSubstr("turbine.yaml:"), HasSubstr("rotor.radius_m: the key is missing"),
                    HasSubstr("'radius'")));
  EXPECT_THAT(
      error_with("gearbox_efficiency: 1.0", "gearbox_efficiency: 1.2"),
      AllOf(HasSubstr("turbine.yaml:17: drive_train.gearbox_efficiency"), HasSubstr("found 1.2")));
  EXPECT_THAT(error_with("max_torque_kNm: 47.4029", "max_torque_kNm: 40"),
              HasSubstr("generator.max_torque_kNm: found less than"));
  EXPECT_THAT(error_with("max_pitch_deg: 90.0", "max_pitch_deg: -1"),
              HasSubstr("pitch.max_pitch_deg: "));
  EXPECT_THAT(error_with("cut_out_wind_mps: 25.0", "cut_out_wind_mps: 2"),
              HasSubstr("operation.cut_out_wind_mps: "));
  EXPECT_THAT(error_with("actuator_enabled: true", "actuator_enabled: 1"),
              HasSubstr("expected true or false"));
  EXPECT_THAT(error_with("tower:", "tower:\n  heigth_m: 3"),
              HasSubstr("tower.heigth_m: unknown key"));
  EXPECT_THAT(error_with("performance_table: cp_ct.txt", "performance_table: none.txt"),
              AllOf(HasSubstr("turbine.yaml:"), HasSubstr("rotor.performance_table: "),
                    HasSubstr("none.txt cannot be read")));
  EXPECT_THAT(error_with("hub_height_m: 90", "hub_height_m: 40"),
              HasSubstr("tower.hub_height_m: found no more than rotor.radius_m"));
}

}  // namespace
}  // namespace lac::sim
