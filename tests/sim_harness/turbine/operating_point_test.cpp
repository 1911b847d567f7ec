// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/operating_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

TurbineParams turbine(const std::string& name) {
  return load_turbine(std::string(LAC_SOURCE_DIR "/config/turbines/") + name + "/turbine.yaml");
}

// NREL 5 MW against the report TP-500-38060: speed 1 %, power 4 % up to rated wind and 1 % above,
// pitch 0.7 deg.
TEST(OperatingPoint, MatchesNrel5MwReport) {
  struct Published {
    double wind_mps, speed_rpm, pitch_deg, power_W, power_tolerance;
  };
  const TurbineParams params = turbine("nrel5mw");
  for (const Published& p :
       {Published{8.0, 9.2, 0.0, 1.78e6, 0.04}, Published{11.4, 12.1, 0.0, 5e6, 0.04},
        Published{14.0, 12.1, 8.70, 5e6, 0.01}, Published{18.0, 12.1, 14.92, 5e6, 0.01},
        Published{24.0, 12.1, 22.35, 5e6, 0.01}}) {
    const OperatingPoint point = steady_state(params, p.wind_mps);
    EXPECT_NEAR(rpm_from_radps(point.rotor_speed_radps), p.speed_rpm, 0.01 * p.speed_rpm)
        << p.wind_mps;
    EXPECT_NEAR(deg_from_rad(point.pitch_rad), p.pitch_deg, 0.7) << p.wind_mps;
    EXPECT_NEAR(point.electrical_power_W, p.power_W, p.power_tolerance * p.power_W) << p.wind_mps;
  }
}

// IEA 3.4 MW against the design workbook, IEA 15 MW against a published feedforward curve.
TEST(OperatingPoint, MatchesPublishedPitchCurves) {
  const TurbineParams iea3p4 = turbine("iea3p4mw");
  const double workbook[][2] = {{11.0, 6.72}, {14.0, 12.36}, {18.0, 18.22}, {25.0, 26.46}};
  for (const auto& [wind_mps, pitch_deg] : workbook) {
    EXPECT_NEAR(deg_from_rad(steady_state(iea3p4, wind_mps).pitch_rad), pitch_deg, 0.8) << wind_mps;
  }
  const TurbineParams iea15 = turbine("iea15mw");
  const double curve[][2] = {{11.0, 0.0614}, {14.0, 0.1790}, {18.0, 0.2732}, {24.0, 0.3824}};
  for (const auto& [wind_mps, pitch_rad] : curve) {
    EXPECT_NEAR(steady_state(iea15, wind_mps).pitch_rad, pitch_rad, 0.006) << wind_mps;
  }
}

// In a steady state nothing moves, whatever the turbine and the region.
TEST(OperatingPoint, IsAnEquilibrium) {
  for (const char* name : {"nrel5mw", "iea3p4mw", "iea15mw"}) {
    const SlowModel model(turbine(name));
    for (const double wind_mps : {4.0, 8.0, 9.8, 10.6, 11.4, 16.0, 25.0}) {
      const OperatingPoint point = steady_state(model.params(), wind_mps);
      const SlowState state = state_at(model.params(), point);
      SlowState rates{};
      model.derivatives(0.0, {wind_mps, 0.0, point.pitch_rad, point.generator_torque_Nm},
                        state.data(), rates.data());
      for (const double rate : rates) EXPECT_NEAR(rate, 0.0, 1e-8) << name << " " << wind_mps;
      EXPECT_LE(point.generator_torque_Nm, model.params().rated_torque_Nm * (1.0 + 1e-9));
      EXPECT_LE(point.rotor_speed_radps, model.params().rated_rotor_speed_radps);
    }
  }
}

// Below rated the region-2 law holds; the speed never falls with the wind.
TEST(OperatingPoint, FollowsRegionTwoLaw) {
  const TurbineParams params = turbine("nrel5mw");
  double last_radps = 0.0;
  for (double wind_mps = 4.0; wind_mps <= 10.0; wind_mps += 0.5) {
    const OperatingPoint point = steady_state(params, wind_mps);
    const double generator_speed_radps = params.gearbox_ratio * point.rotor_speed_radps;
    EXPECT_NEAR(point.generator_torque_Nm,
                params.region2_gain_Nms2prad2 * std::pow(generator_speed_radps, 2),
                1e-6 * point.generator_torque_Nm);
    EXPECT_GT(point.rotor_speed_radps, last_radps);
    last_radps = point.rotor_speed_radps;
  }
}

// No wind, more wind than the table sheds, a gain that stalls the rotor: errors, not numbers.
TEST(OperatingPoint, RefusesTheImpossible) {
  TurbineParams params = turbine("nrel5mw");
  EXPECT_THROW(steady_state(params, 0.0), Error);
  EXPECT_THROW(steady_state(params, NAN), Error);
  EXPECT_THROW(steady_state(params, 80.0), Error);
  params.region2_gain_Nms2prad2 *= 10.0;
  EXPECT_THROW(steady_state(params, 8.0), Error);
}

}  // namespace
}  // namespace lac::sim
