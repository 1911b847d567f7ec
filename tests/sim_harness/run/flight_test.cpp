// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/flight.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/run/probe_case.hpp"
#include "sim_harness/turbine/simulated_turbine.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class FlightTest : public ::testing::Test {
 protected:
  Recording fly_first(const Case& c) {
    const auto wind = make_wind(c.wind);
    const RotorWind rotor_wind(*wind, {63.0, 90.0, 0.0, c.time.duration_s, 0.1});
    FlightReport report;
    report.on_progress = [this](double done) { progress_.push_back(done); };
    report.on_warning = [this](double, const std::string& text) { warnings_.push_back(text); };
    return fly(c, c.controllers[0], *wind, rotor_wind, files_.folder.file("run"), report);
  }

  test::ProbeCase files_;
  std::vector<double> progress_;
  std::vector<std::string> warnings_;
};

// With constant demands the loop is the turbine integrated on its own: same states at the same
// times, to the float precision of the recording; the demands are those of the controller.
TEST_F(FlightTest, ConstantDemandsAreTheTurbineAlone) {
  const Case c = load_case(files_.file());
  const Recording r = fly_first(c);
  ASSERT_EQ(r.rows(), 1601U);
  SimulatedTurbine alone(c.turbine);
  alone.start(steady_state(c.turbine, 18.0));
  const auto speed_rpm = r.column("RotSpeed");
  const auto moment_kNm = r.column("TwrBsMyt");
  for (std::size_t n = 0; n < r.rows(); ++n) {
    const SlowOutputs o = alone.outputs();
    ASSERT_EQ(speed_rpm[n], static_cast<float>(rpm_from_radps(o.rotor_speed_radps))) << n;
    ASSERT_EQ(moment_kNm[n], static_cast<float>(1e-3 * o.tower_base_moment_Nm)) << n;
    // The demands arrive as single precision numbers.
    alone.advance(0.0125, {18.0, 0.0, static_cast<double>(0.26F), 43000.0});
  }
  EXPECT_NEAR(r.column("BldPitchDem")[800], deg_from_rad(0.26), 1e-5);
  EXPECT_NEAR(r.column("GenTqDem")[800], 43.0, 1e-5);
}

// The run starts at rest in the steady state, and progress goes from 0 to 1.
TEST_F(FlightTest, StartsInTheSteadyState) {
  const Case c = load_case(files_.file());
  const Recording r = fly_first(c);
  const OperatingPoint start = steady_state(c.turbine, 18.0);
  EXPECT_NEAR(r.column("RotSpeed")[0], rpm_from_radps(start.rotor_speed_radps), 1e-5);
  EXPECT_NEAR(r.column("BldPitch1")[0], deg_from_rad(start.pitch_rad), 1e-5);
  EXPECT_NEAR(r.column("YawBrTAxp")[0], 0.0, 1e-6);
  EXPECT_EQ(progress_.front(), 0.0);
  EXPECT_EQ(progress_.back(), 1.0);
}

// The true wind: a step of the hub wind arrives at its time, REWS and hub wind alike.
TEST_F(FlightTest, RecordsTheWind) {
  const Case c = load_case(files_.file("  kind: steady\n  speed_mps: 18\n",
                                       "  {kind: step, from_mps: 18, to_mps: 19, time_s: 10, "
                                       "ramp_s: 1}\n"));
  const Recording r = fly_first(c);
  const auto rews = r.column("RtVAvgxh");
  const auto hub = r.column("WindHubVelH");
  EXPECT_NEAR(rews[800], 18.0, 1e-5);
  EXPECT_NEAR(rews[840], 18.5, 1e-5);
  EXPECT_NEAR(rews[880], 19.0, 1e-5);
  for (std::size_t n = 0; n < r.rows(); ++n) ASSERT_NEAR(rews[n], hub[n], 1e-4) << n;
}

// Warnings reach the report, failures end the flight.
TEST_F(FlightTest, WarningsAndFailures) {
  files_.folder.write("probe.in", "quiet 1\nwarn_at 3\n");
  fly_first(load_case(files_.file()));
  EXPECT_THAT(warnings_, ElementsAre("probe: a warning"));
  files_.folder.write("probe.in", "quiet 1\nfail_at 8\n");
  try {
    fly_first(load_case(files_.file()));
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("t = 0.1 s: probe: told to fail"));
  }
}

// What a lidar is told: the thrust coefficient is the c_T of the table at the tip-speed ratio of
// the relative wind, 12 m/s over a tower top that moves up-wind at 0.5 m/s, and 0 from behind.
TEST_F(FlightTest, TellsTheLidarOfTheTurbine) {
  const TurbineParams t = load_case(files_.file()).turbine;
  SlowOutputs o{};
  o.rotor_speed_radps = 1.2;
  o.pitch_rad = 0.02;
  o.tower_x_m = 0.3;
  o.tower_v_mps = -0.5;
  o.thrust_N = t.rotor.thrust_N(12.5, 1.2, 0.02);
  const TurbineState told = turbine_state(o, t, 12.0, 2.5);
  const double expected =
      o.thrust_N / (0.5 * 1.225 * kPi * 63.0 * 63.0 * 12.5 * 12.5);  // air density of the file
  EXPECT_NEAR(told.thrust_coefficient, expected, 1e-12);
  EXPECT_GT(expected, 0.5);
  EXPECT_LT(expected, 0.9);
  EXPECT_EQ(told.azimuth_rad, 2.5);
  EXPECT_EQ(told.rotor_speed_radps, 1.2);
  EXPECT_EQ(told.pitch_rad, 0.02);
  EXPECT_EQ(told.tower_x_m, 0.3);
  EXPECT_EQ(told.tower_v_mps, -0.5);
  EXPECT_EQ(turbine_state(o, t, -1.0, 0.0).thrust_coefficient, 0.0);
}

// A lidar on board fills the native block: the flag comes up with the first beam at 0.25 s, and
// at no other of the first 21 calls.
TEST_F(FlightTest, LidarOnBoard) {
  files_.folder.write("probe.in", "pitch_rad 0.26\ntorque_Nm 43000\n");
  const Case c =
      load_case(files_.file("outputs:", "lidar: {file: " LAC_SOURCE_DIR
                                        "/config/lidars/four_beam_pulsed.yaml}\noutputs:"));
  fly_first(c);
  std::istringstream seen(files_.folder.read("run.SrvD.seen"));
  std::string line;
  for (int call = 0; call <= 20; ++call) {
    std::getline(seen, line);
    EXPECT_THAT(line, HasSubstr(" 1101=1 1102=" + std::string(call == 20 ? "1" : "0"))) << call;
  }
}

}  // namespace
}  // namespace lac::sim
