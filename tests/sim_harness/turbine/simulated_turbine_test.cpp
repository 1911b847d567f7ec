// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/simulated_turbine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "support/no_alloc_guard.hpp"
#include "support/rk4.hpp"

namespace lac::sim {
namespace {

constexpr double kStep_s = 0.0125;

TurbineParams nrel5mw() {
  return load_turbine(LAC_SOURCE_DIR "/config/turbines/nrel5mw/turbine.yaml");
}

double wind_mps(double t) {
  return 14.0 + 2.5 * std::sin(0.31 * t) + 1.5 * std::sin(1.7 * t) + 0.5 * std::sin(7.1 * t);
}

/// Demands that follow the rotor speed with some gain, and jump now and then.
SlowInputs demands(int k, const TurbineParams& params, const SlowState& state) {
  const double t = kStep_s * k;
  const double jump_rad = (k / 400) % 2 == 0 ? 0.0 : 0.02;
  const double error_radps = state[kRotorSpeed] - params.rated_rotor_speed_radps;
  return {wind_mps(t), (wind_mps(t + kStep_s) - wind_mps(t)) / kStep_s,
          0.15 + 1.5 * error_radps + jump_rad,
          params.rated_power_W / (params.generator_efficiency * 97.0 * state[kRotorSpeed])};
}

// 60 s of varying wind and jumping demands against RK4 with a step of 0.25 ms.
TEST(SimulatedTurbine, AgreesWithFineFixedStepReference) {
  const TurbineParams params = nrel5mw();
  const SlowModel model(params);
  const OperatingPoint point = steady_state(params, 14.0);
  SimulatedTurbine turbine(params);
  turbine.start(point);
  SlowState reference = state_at(params, point);
  for (int k = 0; k < 4800; ++k) {
    const SlowInputs inputs = demands(k, params, reference);
    turbine.advance(kStep_s, inputs);
    test::rk4(
        [&](double t, const double* y, double* rates) { model.derivatives(t, inputs, y, rates); },
        kStep_s, 50, reference);
    ASSERT_NEAR(turbine.state()[kRotorSpeed], reference[kRotorSpeed], 1e-6 * reference[kRotorSpeed])
        << k;
    ASSERT_NEAR(turbine.state()[kPitch], reference[kPitch], 1e-5) << k;
    ASSERT_NEAR(turbine.state()[kTowerX], reference[kTowerX], 1e-5) << k;
  }
}

// The same in closed loop, where errors feed back through the demands.
TEST(SimulatedTurbine, ClosedLoopAgreesWithReference) {
  const TurbineParams params = nrel5mw();
  const SlowModel model(params);
  SimulatedTurbine turbine(params);
  turbine.start(steady_state(params, 14.0));
  SlowState reference = turbine.state();
  for (int k = 0; k < 4800; ++k) {
    turbine.advance(kStep_s, demands(k, params, turbine.state()));
    const SlowInputs inputs = demands(k, params, reference);
    test::rk4(
        [&](double t, const double* y, double* rates) { model.derivatives(t, inputs, y, rates); },
        kStep_s, 10, reference);
    ASSERT_NEAR(turbine.state()[kRotorSpeed], reference[kRotorSpeed], 1e-5 * reference[kRotorSpeed])
        << k;
  }
}

// Two turbines taking turns equal two that run alone, to the last bit.
TEST(SimulatedTurbine, InstancesDoNotDisturbEachOther) {
  const TurbineParams params = nrel5mw();
  const auto run = [&](SimulatedTurbine& turbine, int k, int shift) {
    turbine.advance(kStep_s, demands(k + shift, params, turbine.state()));
  };
  SimulatedTurbine a(params), b(params), a_alone(params), b_alone(params);
  for (SimulatedTurbine* t : {&a, &b, &a_alone, &b_alone}) t->start(steady_state(params, 14.0));
  for (int k = 0; k < 800; ++k) {
    run(a, k, 0);
    run(b, k, 777);
  }
  for (int k = 0; k < 800; ++k) run(a_alone, k, 0);
  for (int k = 0; k < 800; ++k) run(b_alone, k, 777);
  EXPECT_EQ(a.state(), a_alone.state());
  EXPECT_EQ(b.state(), b_alone.state());
  EXPECT_NE(a.state(), b.state());
}

// A turbine started again forgets what it did before.
TEST(SimulatedTurbine, StartsAfresh) {
  const TurbineParams params = nrel5mw();
  SimulatedTurbine used(params), fresh(params);
  used.start(steady_state(params, 20.0));
  for (int k = 0; k < 100; ++k) used.advance(kStep_s, demands(k, params, used.state()));
  used.start(steady_state(params, 14.0));
  fresh.start(steady_state(params, 14.0));
  for (SimulatedTurbine* t : {&used, &fresh}) t->advance(kStep_s, demands(3, params, t->state()));
  EXPECT_EQ(used.state(), fresh.state());
}

// In steady wind with steady demands the operating point stays.
TEST(SimulatedTurbine, StaysInSteadyState) {
  const TurbineParams params = nrel5mw();
  const OperatingPoint point = steady_state(params, 18.0);
  SimulatedTurbine turbine(params);
  turbine.start(point);
  for (int k = 0; k < 8000; ++k) {
    turbine.advance(kStep_s, {18.0, 0.0, point.pitch_rad, point.generator_torque_Nm});
  }
  EXPECT_NEAR(turbine.outputs().rotor_speed_radps, point.rotor_speed_radps, 1e-8);
  EXPECT_NEAR(turbine.outputs().electrical_power_W, point.electrical_power_W, 1.0);
  EXPECT_NEAR(turbine.outputs().thrust_N, point.thrust_N, 1.0);
}

// After the first interval the solver does not allocate, not even where it has to cut steps
// (the pitch runs into its stop).
TEST(SimulatedTurbine, DoesNotAllocate) {
  const TurbineParams params = nrel5mw();
  SimulatedTurbine turbine(params);
  turbine.start(steady_state(params, 14.0));
  turbine.advance(kStep_s, demands(0, params, turbine.state()));
  const test::NoAllocGuard guard;
  for (int k = 1; k < 400; ++k) {
    SlowInputs inputs = demands(k, params, turbine.state());
    if (k > 100) inputs.pitch_demand_rad = 0.0;
    turbine.advance(kStep_s, inputs);
  }
  EXPECT_EQ(guard.allocations(), 0U);
  EXPECT_GT(turbine.statistics().rejected_steps, 0);
}

// Wind that is not a number ends the run with an error, not with numbers.
TEST(SimulatedTurbine, RefusesWindThatIsNotANumber) {
  SimulatedTurbine turbine(nrel5mw());
  turbine.start(steady_state(turbine.params(), 12.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(turbine.advance(kStep_s, {nan, 0.0, 0.1, 4e4}), Error);
}

}  // namespace
}  // namespace lac::sim
