// SPDX-License-Identifier: Apache-2.0
// The wind sections of case files: events of the standard, files, and what is done to a wind.
#include "sim_harness/run/wind_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "sim_harness/wind/bts_file.hpp"
#include "sim_harness/wind/iec_wind.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"
#include "tests/sim_harness/wind/wind_bytes.hpp"

namespace lac::sim {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class WindCaseTest : public testing::Test {
 protected:
  /// Hub at 90 m, rotor of 63 m, seed 5.
  WindCase read(const std::string& section, std::optional<WindDemand> lidar = {}) {
    YamlReader in = YamlReader::load(folder_.write("wind.yaml", section));
    const WindCase wind = read_wind(in, {90.0, 63.0, 5, std::move(lidar)});
    in.finish();
    return wind;
  }
  std::string error(const std::string& section) {
    return lac::test::error_text([&] { make_wind(read(section)); });
  }
  template <class History>
  History history(const std::string& section) {
    return std::get<History>(std::get<UniformWindParams>(read(section).source).history);
  }

  lac::test::TempFolder folder_;
};

// Direction change: the standard's angle, its sign, an angle of one's own, edition 4's category.
TEST_F(WindCaseTest, DirectionChange) {
  const std::string keys = "{kind: edc, mean_speed_mps: 18, start_s: 9";
  const auto standard = history<DirectionChange>(keys + "}");
  EXPECT_EQ(standard.start_s, 9.0);
  EXPECT_DOUBLE_EQ(standard.angle_rad, edc_angle_rad(TurbulenceCategory::kA, 18.0, 90.0, 126.0));
  EXPECT_DOUBLE_EQ(history<DirectionChange>(keys + ", sign: negative}").angle_rad,
                   -standard.angle_rad);
  EXPECT_DOUBLE_EQ(history<DirectionChange>(keys + ", angle_deg: 30}").angle_rad,
                   rad_from_deg(30.0));
  EXPECT_DOUBLE_EQ(history<DirectionChange>(keys + ", turbulence_category: A+}").angle_rad,
                   edc_angle_rad(TurbulenceCategory::kAPlus, 18.0, 90.0, 126.0));
}

// Coherent gust: 15 m/s and 720/V deg; the class does not matter and is no key.
TEST_F(WindCaseTest, CoherentGust) {
  const auto gust =
      history<CoherentGust>("{kind: ecd, mean_speed_mps: 12, start_s: 9, sign: negative}");
  EXPECT_EQ(gust.gust_mps, 15.0);
  EXPECT_NEAR(deg_from_rad(gust.angle_rad), -60.0, 1e-12);
  EXPECT_THAT(error("{kind: ecd, mean_speed_mps: 12, start_s: 9, wind_class: I}"),
              HasSubstr("wind_class: unknown key"));
}

// Extreme shear: both axes and signs; shears count on the rotor's diameter.
TEST_F(WindCaseTest, ExtremeShear) {
  const std::string keys = "{kind: ews, mean_speed_mps: 18, start_s: 9";
  const double a_mps = ews_amplitude_mps(TurbulenceCategory::kA, 18.0, 90.0, 126.0);
  const auto vertical = history<ShearEvent>(keys + "}");
  EXPECT_EQ(vertical.axis, ShearEvent::Axis::kVertical);
  EXPECT_DOUBLE_EQ(vertical.amplitude_mps, a_mps);
  const auto horizontal = history<ShearEvent>(keys + ", shear: horizontal, sign: negative}");
  EXPECT_EQ(horizontal.axis, ShearEvent::Axis::kHorizontal);
  EXPECT_DOUBLE_EQ(horizontal.amplitude_mps, -a_mps);
  EXPECT_NEAR(make_wind(read(keys + "}"))->velocity({0.0, 0.0, 153.0}, 15.0).x, 18.0 + a_mps, 1e-9);
}

// A uniform wind file: its rows, its own shear, the speed that carries it.
TEST_F(WindCaseTest, UniformFile) {
  folder_.write("w.hh", "0 12 0 0 0 0.2 0 0\n10 14 20 0 0 0.2 0 0\n");
  const auto wind = make_wind(read("{kind: uniform_file, file: w.hh}"));
  EXPECT_NEAR(wind->velocity({0.0, 0.0, 45.0}, 0.0).x, 12.0 * std::pow(0.5, 0.2), 1e-9);
  EXPECT_NEAR(wind->velocity({0.0, 0.0, 90.0}, 99.0).y, -14.0 * std::sin(rad_from_deg(20.0)), 1e-9);
  EXPECT_EQ(wind->mean_speed_mps(), 12.0);
  EXPECT_THAT(describe(read("{kind: uniform_file, file: w.hh}")),
              EndsWith("table of 2 rows up to 10 s"));
  folder_.write("w.hh", "0 12 0 0\n");
  EXPECT_THAT(error("{kind: uniform_file, file: w.hh}"), HasSubstr("w.hh:1: found 4 numbers"));
}

// One field in three formats gives one wind.
TEST_F(WindCaseTest, FieldFiles) {
  const GriddedWind field = wavy(true);
  write_field({FieldFormat::kBts, folder_.file("f.bts")}, field, "");
  write_field({FieldFormat::kBladed, folder_.file("f.wnd")}, field, "");
  write_field({FieldFormat::kBox, folder_.file("f.bin")}, field, "");
  const std::string box =
      "{kind: hawc2, file: f-u.bin, points: [50, 4, 3], spacing_m: [3.125, 8, 9], "
      "mean_speed_mps: 12.5, centre_height_m: 39}";
  for (const std::string& section :
       {std::string("{kind: bts, file: f.bts}"), std::string("{kind: bladed, file: f.wnd}"), box}) {
    const auto wind = make_wind(read(section));
    for (const double t : {0.0, 3.75, 12.0}) {
      const Vec3 found = wind->velocity({0.0, 4.0, 39.0}, t),
                 expected = field.velocity({0.0, 4.0, 39.0}, t);
      EXPECT_LT(norm(found - expected), 2e-3) << section << t;
    }
  }
  EXPECT_THAT(error("{kind: hawc2, file: f.bin, points: [50, 4], spacing_m: [1, 1, 1], "
                    "mean_speed_mps: 1}"),
              HasSubstr("points: expected three numbers"));
  EXPECT_THAT(error("{kind: bladed, file: f.bts}"), HasSubstr("found 8, expected -99"));
}

// What is done to a field: fluctuations, shear and veer on the numbers, then the turn; in words.
TEST_F(WindCaseTest, ShapeAndDirection) {
  write_field({FieldFormat::kBts, folder_.file("f.bts")}, wavy(true), "");
  const WindCase wind = read(
      "{kind: bts, file: f.bts, fluctuation_scale: [0.5, 1, 1], shear_exponent: 0.1, "
      "veer_deg_per_m: 0.2, yaw_deg: 2, reach_m: 20}");
  EXPECT_EQ(wind.shape.fluctuation_scale[0], 0.5);
  EXPECT_EQ(wind.shape.shear_exponent, 0.1);
  EXPECT_DOUBLE_EQ(wind.shape.veer_radpm, rad_from_deg(0.2));
  EXPECT_DOUBLE_EQ(wind.direction.yaw_rad, rad_from_deg(2.0));
  EXPECT_EQ(describe(wind),
            "file f.bts, fluctuations times 0.5, 1, 1, shear exponent 0.1, veer 0.2 deg/m, yaw 2 "
            "deg");
  EXPECT_NEAR(make_wind(wind)->mean_speed_mps(), 12.5 * std::cos(rad_from_deg(2.0)), 1e-9);
  EXPECT_THAT(error("{kind: bts, file: f.bts, yaw_deg: 10}"), HasSubstr("width left [m]"));
  EXPECT_THAT(error("{kind: steady, speed_mps: 10, veer_deg_per_m: 0.1}"),
              HasSubstr("veer_deg_per_m: unknown key"));
}

// A steady wind from the side and upwards: the whole of it is turned.
TEST_F(WindCaseTest, TurnedSteadyWind) {
  const auto wind = make_wind(read("{kind: steady, speed_mps: 10, yaw_deg: 20, upflow_deg: 8}"));
  const Vec3 v = wind->velocity({-30.0, 5.0, 80.0}, 3.0);
  EXPECT_NEAR(v.x, 10.0 * std::cos(rad_from_deg(20.0)) * std::cos(rad_from_deg(8.0)), 1e-9);
  EXPECT_NEAR(v.y, -10.0 * std::sin(rad_from_deg(20.0)) * std::cos(rad_from_deg(8.0)), 1e-9);
  EXPECT_NEAR(v.z, 10.0 * std::sin(rad_from_deg(8.0)), 1e-9);
}

// Turned wind reaches as far as the lidar measures, motion included; less is refused. Wind that
// does not turn, or without a lidar, takes any reach.
TEST_F(WindCaseTest, ReachOfTheLidar) {
  WindDemand lidar;
  lidar.points_I_m = {{-100.0, 0.0, 90.0}, {-340.0, 5.0, 80.0}};
  lidar.margin_m = 3.0;
  const auto reach_m = [&](const std::string& keys, std::optional<WindDemand> demand) {
    return read("{kind: steady, speed_mps: 10" + keys + "}", std::move(demand)).direction.reach_m;
  };
  EXPECT_EQ(reach_m(", yaw_deg: 30", lidar), 343.0);
  EXPECT_EQ(reach_m(", upflow_deg: 5, reach_m: 400", lidar), 400.0);
  EXPECT_EQ(reach_m(", yaw_deg: 30", std::nullopt), 250.0);
  EXPECT_EQ(reach_m(", yaw_deg: 30, reach_m: 0", std::nullopt), 0.0);
  EXPECT_EQ(reach_m(", reach_m: 0", lidar), 0.0);
  EXPECT_THAT(test::error_text([&] { reach_m(", yaw_deg: 30, reach_m: 0", lidar); }),
              HasSubstr("wind.yaml:1: reach_m: found 0, expected at least 343"));
  lidar.points_I_m.pop_back();
  EXPECT_EQ(reach_m(", yaw_deg: 30", lidar), 250.0);
}

}  // namespace
}  // namespace lac::sim
