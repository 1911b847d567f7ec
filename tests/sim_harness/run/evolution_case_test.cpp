// SPDX-License-Identifier: Apache-2.0
// The planes of evolving wind: from the lidar's gates, or checked against them; and what of them
// is kept.
#include "sim_harness/run/evolution_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim_harness/lidar/beam_extent.hpp"
#include "sim_harness/lidar/lidar_sim.hpp"
#include "sim_harness/wind/rotor_wind.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

/// Two beams with gates at 60 and 100 m, 2 m nearer on the second beam.
WindDemand two_gates() {
  WindDemand demand;
  for (const int gate : {1, 2}) {
    const double x_m = gate == 1 ? -60.0 : -100.0;
    demand.gates.push_back({1, gate, {x_m, 10.0, 95.0}});
    demand.gates.push_back({2, gate, {x_m + 2.0, -10.0, 85.0}});
  }
  for (const GateCentre& gate : demand.gates) demand.points_I_m.push_back(gate.position_I_m);
  demand.margin_m = 2.0;
  return demand;
}

class EvolutionCaseTest : public testing::Test {
 protected:
  WindCase read(const std::string& evolution, std::optional<WindDemand> lidar,
                const std::string& more = "", int points = 15) {
    const std::string count = std::to_string(points);
    YamlReader in = YamlReader::load(folder_.write(
        "wind.yaml",
        "{kind: mann, mean_speed_mps: 16, time_step_s: 0.5, period_s: 32, "
        "points_across: " +
            count + ", points_up: " + count + ", evolution: {" + evolution + "}" + more + "}"));
    const WindCase wind = read_wind(in, {90.0, 63.0, 5, std::move(lidar)});
    in.finish();
    return wind;
  }
  std::vector<double> planes_m(const std::string& evolution, std::optional<WindDemand> lidar) {
    return std::get<MannWind>(read(evolution, std::move(lidar)).source).planes_m;
  }
  std::string error(const std::string& evolution, std::optional<WindDemand> lidar) {
    return test::error_text([&] { read(evolution, std::move(lidar)); });
  }

  test::TempFolder folder_;
};

// Without planes_m there is one plane at each gate of the lidar; a list of one's own is taken.
TEST_F(EvolutionCaseTest, Planes) {
  EXPECT_EQ(planes_m("", two_gates()), (std::vector{59.0, 99.0}));
  EXPECT_EQ(planes_m("planes_m: [50, 90]", two_gates()), (std::vector{50.0, 90.0}));
  EXPECT_EQ(planes_m("planes_m: [50, 80]", std::nullopt), (std::vector{50.0, 80.0}));
}

// Faults: nothing says where planes are, they do not rise, gates out of their reach (here 105 m of
// planes at 70 and 90 m reach 100 m).
TEST_F(EvolutionCaseTest, Faults) {
  EXPECT_THAT(error("", std::nullopt),
              HasSubstr("evolution.planes_m: missing: expected distances"));
  EXPECT_THAT(error("", WindDemand{}), HasSubstr("or a lidar whose gates say them"));
  EXPECT_THAT(error("planes_m: [80, 50]", std::nullopt), HasSubstr("expected distances that rise"));
  EXPECT_THAT(planes_m("planes_m: [70, 90]", two_gates()), testing::SizeIs(2));
  WindDemand far = two_gates();
  far.gates.push_back({2, 3, {-105.0, 0.0, 90.0}});
  EXPECT_THAT(error("planes_m: [70, 90]", far),
              HasSubstr("wind.yaml:1: evolution.planes_m: beam 2, gate 3 of the lidar is centred "
                        "105 m up-wind; planes up to 90 m reach to 100 m"));
}

// Gates whose nearest plane is the rotor's, or close to it, would see frozen wind.
TEST_F(EvolutionCaseTest, PlanesTooFarFromAGate) {
  EXPECT_THAT(
      error("planes_m: [1000]", two_gates()),
      HasSubstr("wind.yaml:1: evolution.planes_m: beam 1, gate 1 of the lidar is centred 60 "
                "m up-wind; the nearest plane, at 0 m, the rotor's own"));
  EXPECT_THAT(
      error("planes_m: [1e-3, 340]", two_gates()),
      HasSubstr("beam 1, gate 1 of the lidar is centred 60 m up-wind; the nearest plane, at "
                "0.001 m,"));
  EXPECT_THAT(error("planes_m: [60, 1000]", two_gates()), HasSubstr("no error"));
  EXPECT_THAT(error("planes_m: [29, 100]", two_gates()), HasSubstr("beam 1, gate 1"));
  EXPECT_THAT(error("planes_m: [31, 100]", two_gates()), HasSubstr("no error"));
}

// What is kept for a demand is the whole wind there, shape and all; the rotor plane is whole.
TEST_F(EvolutionCaseTest, KeepsWhatIsDemanded) {
  const WindDemand demand = two_gates();
  const WindCase wind = read("", demand, ", veer_deg_per_m: 0.1, shear_exponent: 0.2");
  EXPECT_TRUE(evolves(wind));
  const auto thinned = make_wind(wind, &demand), whole = make_wind(wind);
  for (const Vec3& point : demand.points_I_m) {
    for (const double step_m : {-1.9, 0.0, 1.9}) {
      const Vec3 p = point + Vec3{step_m, -step_m, step_m};
      ASSERT_TRUE(thinned->holds(p));
      EXPECT_EQ(thinned->velocity(p, 7.3), whole->velocity(p, 7.3));
    }
  }
  const Vec3 away{-60.0, -50.0, 60.0}, rotor{0.0, -50.0, 60.0};
  EXPECT_TRUE(whole->holds(away));
  EXPECT_FALSE(thinned->holds(away));
  EXPECT_EQ(thinned->velocity(rotor, 3.1), whole->velocity(rotor, 3.1));
}

// Scaled fluctuations count from the mean of the kept columns, which is that of the height to
// rounding.
TEST_F(EvolutionCaseTest, ScalesFluctuations) {
  const WindDemand demand = two_gates();
  const WindCase wind = read("", demand, ", fluctuation_scale: [0.5, 2, 1]");
  const auto thinned = make_wind(wind, &demand), whole = make_wind(wind);
  for (const Vec3& p : demand.points_I_m)
    EXPECT_LT(norm(thinned->velocity(p, 7.3) - whole->velocity(p, 7.3)), 2e-5);
}

// A shipped lidar on a tower top that moves by up to its allowance of 3 m measures the same in what
// was kept for it as in whole planes, to the last bit; far less than half of each plane is kept.
TEST_F(EvolutionCaseTest, LidarMeasuresTheSame) {
  const LidarParams lidar = load_lidar(LAC_SOURCE_DIR "/config/lidars/four_beam_pulsed.yaml");
  const WindDemand demand = wind_demand(lidar, 90.0);
  const WindCase wind = read("", demand, ", box_points_across: 42, box_points_up: 42", 41);
  const auto thinned = make_wind(wind, &demand), whole = make_wind(wind);
  const auto& planes = dynamic_cast<const EvolvingWind&>(*thinned);
  ASSERT_EQ(planes.layout().size(), 11U);
  for (std::size_t plane = 1; plane <= 10; ++plane)
    EXPECT_LT(planes.upwind_plane(plane).columns().count(), 41U * 41U / 3U);
  const LidarSetting setting{90.0, 0.0125, 20.0};
  LidarSim found(lidar, *thinned, setting), expected(lidar, *whole, setting);
  LidarMeasurement a, b;
  int measurements = 0;
  for (int n = 0; n <= 1600; ++n) {
    const TurbineState turbine{.tower_x_m = 3.0 * std::sin(0.003 * n)};
    if (!found.step(n, turbine, a)) continue;
    ASSERT_TRUE(expected.step(n, turbine, b));
    ++measurements;
    for (int gate = 0; gate < a.gate_count; ++gate)
      EXPECT_EQ(a.gates[gate].speed_mps, b.gates[gate].speed_mps);
  }
  EXPECT_EQ(measurements, 80);
}

// Turned wind: points are demanded where the turn takes them, and the rotor, which cuts through
// planes, is there as a whole.
TEST_F(EvolutionCaseTest, TurnedWind) {
  WindDemand demand = two_gates();
  demand.points_I_m.push_back({-59.0, 12.0, 97.0});
  const WindCase wind = read("planes_m: [20, 60, 100]", demand,
                             ", yaw_deg: 20, upflow_deg: 5, width_m: 260, height_m: 175, "
                             "reach_m: 110");
  const auto thinned = make_wind(wind, &demand), whole = make_wind(wind);
  for (const Vec3& p : demand.points_I_m) {
    EXPECT_TRUE(thinned->holds(p));
    EXPECT_EQ(thinned->velocity(p, 7.3), whole->velocity(p, 7.3));
  }
  EXPECT_FALSE(thinned->holds({-60.0, -60.0, 60.0}));
  const RotorWindParams rotor{63.0, 90.0, 0.0, 20.0, 0.5};
  const RotorWind found(*thinned, rotor), expected(*whole, rotor);
  EXPECT_TRUE(std::ranges::equal(found.samples_mps(), expected.samples_mps()));
}

}  // namespace
}  // namespace lac::sim
