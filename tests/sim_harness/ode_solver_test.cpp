// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/ode_solver.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"

namespace lac::sim {
namespace {

using State = std::array<double, 2>;

struct Drive {
  double frequency_radps;
  double force;
};

/// y'' = -w^2 y + force.
void driven_oscillator(double, const double* y, double* rates, const void* context) {
  const auto& drive = *static_cast<const Drive*>(context);
  rates[0] = y[1];
  rates[1] = -drive.frequency_radps * drive.frequency_radps * y[0] + drive.force;
}

OdeSolver make_solver() {
  return OdeSolver(driven_oscillator, 1e-8, {1e-10, 1e-10});
}

// A free oscillation over many intervals against cosine and sine.
TEST(OdeSolver, FollowsAnalyticOscillation) {
  OdeSolver solver = make_solver();
  const Drive drive{2.0, 0.0};
  State y{1.0, 0.0};
  for (int k = 1; k <= 800; ++k) {
    solver.advance(0.0125, y.data(), &drive);
    const double t = 0.0125 * k;
    ASSERT_NEAR(y[0], std::cos(2.0 * t), 1e-6);
    ASSERT_NEAR(y[1], -2.0 * std::sin(2.0 * t), 2e-6);
  }
}

// The time counts from the start of each interval: y' = t gives duration^2 / 2 every time.
TEST(OdeSolver, TimeStartsAtEachInterval) {
  OdeSolver solver([](double t, const double*, double* rates, const void*) { *rates = t; }, 1e-8,
                   {1e-10});
  double y = 0.0;
  for (int k = 0; k < 3; ++k) solver.advance(0.5, &y, nullptr);
  EXPECT_NEAR(y, 3.0 * 0.125, 1e-9);
}

// After a jump of the demand, a used solver gives what a fresh one gives, to the last bit.
TEST(OdeSolver, NothingOutlivesAnInterval) {
  OdeSolver used = make_solver();
  const Drive before{3.0, 1.0};
  const Drive after{3.0, -50.0};
  State y{0.3, 0.1};
  for (int k = 0; k < 10; ++k) used.advance(0.0125, y.data(), &before);

  State expected = y;
  OdeSolver fresh = make_solver();
  fresh.advance(0.0125, expected.data(), &after);
  used.advance(0.0125, y.data(), &after);
  EXPECT_EQ(y, expected);
}

// Two solvers taking turns give what each gives alone, to the last bit.
TEST(OdeSolver, InstancesDoNotDisturbEachOther) {
  const Drive slow{1.0, 0.5};
  const Drive fast{40.0, -2.0};
  const auto alone = [](const Drive& drive) {
    OdeSolver solver = make_solver();
    State y{1.0, 0.0};
    for (int k = 0; k < 50; ++k) solver.advance(0.0125, y.data(), &drive);
    return y;
  };
  OdeSolver a = make_solver();
  OdeSolver b = make_solver();
  State ya{1.0, 0.0};
  State yb{1.0, 0.0};
  for (int k = 0; k < 50; ++k) {
    a.advance(0.0125, ya.data(), &slow);
    b.advance(0.0125, yb.data(), &fast);
  }
  EXPECT_EQ(ya, alone(slow));
  EXPECT_EQ(yb, alone(fast));
}

// A smooth interval is one step of four evaluations; a fast oscillation is cut into more.
TEST(OdeSolver, StepsAsTheToleranceAsks) {
  OdeSolver solver(driven_oscillator, 1e-6, {1e-6, 1e-6});
  State y{1.0, 0.0};
  const Drive slow{0.5, 0.0};
  solver.advance(0.0125, y.data(), &slow);
  EXPECT_EQ(solver.statistics().steps, 1);
  EXPECT_EQ(solver.statistics().rejected_steps, 0);
  EXPECT_EQ(solver.statistics().function_calls, 4);

  const Drive fast{500.0, 0.0};
  y = {1.0, 0.0};
  solver.advance(0.0125, y.data(), &fast);
  EXPECT_GT(solver.statistics().steps, 10);
  EXPECT_GT(solver.statistics().rejected_steps, 0);
  EXPECT_NEAR(y[0], std::cos(500.0 * 0.0125), 1e-3);
}

// An input that is not finite is reported, and the solver works again afterwards.
TEST(OdeSolver, ReportsFailureAndRecovers) {
  OdeSolver solver = make_solver();
  State y{1.0, 0.0};
  const Drive bad{1.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(solver.advance(0.0125, y.data(), &bad), Error);

  const Drive good{1.0, 0.0};
  y = {1.0, 0.0};
  solver.advance(0.0125, y.data(), &good);
  EXPECT_NEAR(y[0], std::cos(0.0125), 1e-9);
}

// Moving a solver keeps it working.
TEST(OdeSolver, CanBeMoved) {
  OdeSolver first = make_solver();
  OdeSolver second = std::move(first);
  const Drive drive{1.0, 0.0};
  State y{1.0, 0.0};
  second.advance(0.1, y.data(), &drive);
  EXPECT_NEAR(y[0], std::cos(0.1), 1e-7);
}

}  // namespace
}  // namespace lac::sim
