// SPDX-License-Identifier: Apache-2.0
// The harness with SUNDIALS against the same loop written down once more here, with a fixed-step
// Runge-Kutta method of fourth order and twelve steps per controller step.
#include <gtest/gtest.h>

#include <iostream>

#include "closed_loop/case_flight.hpp"
#include "core/units.hpp"
#include "sim_harness/host/controller_host.hpp"
#include "sim_harness/lidar/lidar_sim.hpp"
#include "sim_harness/turbine/operating_point.hpp"
#include "support/rk4.hpp"

namespace lac::test {
namespace {

constexpr int kSubsteps = 12;

class SolverReference : public testing::TestWithParam<std::size_t> {
 protected:
  sim::HostSetup setup(const std::string& root) const {
    sim::HostSetup s;
    s.library_folders = {LAC_LIBRARY_DIR};
    s.input_file = demo.c.controllers.at(GetParam()).input_file.string();
    s.output_root = root;
    s.time_step_s = demo.c.time.step_s;
    s.initial_pitch_rad = start.pitch_rad;
    s.generator_efficiency = demo.c.turbine.generator_efficiency;
    return s;
  }

  sim::HostInputs measured(const sim::SlowState& state, double time_s) const {
    sim::HostInputs in;
    in.pitch_rad = state[sim::kPitch];
    in.rotor_speed_radps = state[sim::kRotorSpeed];
    in.generator_speed_radps = demo.c.turbine.gearbox_ratio * state[sim::kRotorSpeed];
    in.hub_wind_mps = demo.wind->velocity({0.0, 0.0, demo.c.turbine.hub_height_m}, time_s).x;
    return in;
  }

  /// Rotor speed in rpm at each controller step.
  std::vector<double> reference_rpm() const {
    const TempFolder results;
    const double dt_s = demo.c.time.step_s;
    const sim::SlowModel model(demo.c.turbine);
    sim::SlowState state = sim::state_at(demo.c.turbine, start);
    sim::ControllerHost host(setup(results.file("run")), [](double, const std::string&) {});
    sim::LidarSim lidar(demo.c.lidar->params, *demo.wind,
                        {demo.c.turbine.hub_height_m, dt_s, demo.c.time.duration_s});
    LidarMeasurement measurement;
    std::vector<double> speed_rpm;
    for (std::int64_t n = 0; n <= demo.c.time.steps(); ++n) {
      const double time_s = static_cast<double>(n) * dt_s;
      speed_rpm.push_back(rpm_from_radps(state[sim::kRotorSpeed]));
      const bool is_new = lidar.step(n, {state[sim::kTowerX], state[sim::kTowerV]}, measurement);
      host.set_lidar(measurement, is_new);
      const sim::HostDemands demands = host.call(measured(state, time_s));
      const double wind_mps = demo.rotor_wind.at(time_s);
      const double slope_mps2 =
          (demo.rotor_wind.at(static_cast<double>(n + 1) * dt_s) - wind_mps) / dt_s;
      const sim::SlowInputs inputs{wind_mps, slope_mps2, demands.pitch_rad, demands.torque_Nm};
      const auto rates = [&](double t, const double* y, double* dy) {
        model.derivatives(t, inputs, y, dy);
      };
      rk4(rates, dt_s, kSubsteps, state);
    }
    return speed_rpm;
  }

  /// One wind for all tests.
  static const CaseFlight& shared_demo() {
    static const CaseFlight flight(
        "demo.yaml", kSanitized
                         ? std::vector<std::string>{"time.duration_s=70", "wind.period_s=100"}
                         : std::vector<std::string>{"time.duration_s=600"});
    return flight;
  }

  const CaseFlight& demo = shared_demo();
  sim::OperatingPoint start = sim::steady_state(demo.c.turbine, demo.rotor_wind.at(0.0));
};

// 600 s of turbulence: rotor speed within 1e-4 relative throughout. The controllers see single
// precision, so that the two runs differ by that much at least.
TEST_P(SolverReference, RotorSpeedAgrees) {
  const std::vector<double> expected = reference_rpm();
  const auto speed_rpm = demo.fly(GetParam()).recording.column("RotSpeed");
  ASSERT_EQ(speed_rpm.size(), expected.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    largest = std::max(largest, std::abs(speed_rpm[i] / expected[i] - 1.0));
  }
  std::cout << "largest relative difference of the rotor speed: " << largest << '\n';
  EXPECT_LT(largest, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(FeedbackAndLidar, SolverReference, testing::Values(0U, 1U));

}  // namespace
}  // namespace lac::test
