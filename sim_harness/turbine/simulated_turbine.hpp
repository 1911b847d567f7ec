// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_harness/ode_solver.hpp"
#include "sim_harness/turbine/operating_point.hpp"
#include "sim_harness/turbine/slow_model.hpp"

namespace lac::sim {

/// SLOW and its solver: a turbine that is moved from one controller call to the next.
///
///     SimulatedTurbine turbine(load_turbine(path));
///     turbine.start(steady_state(turbine.params(), 18.0));
///     each interval: turbine.advance(dt_s, inputs); turbine.outputs()
///
/// Tolerances: relative 1e-6, absolute 1e-8 rad/s, 1e-6 m, 1e-6 m/s, 1e-7 rad, 1e-6 rad/s, 1 N m.
class SimulatedTurbine {
 public:
  explicit SimulatedTurbine(const TurbineParams& params);

  /// At rest in this operating point.
  void start(const OperatingPoint& point);

  /// Moves on by `duration_s` > 0 with the demands held and the wind linear in time. Throws Error
  /// when the integration fails (an input that is not finite).
  void advance(double duration_s, const SlowInputs& inputs);

  /// At the end of the last interval, or at the start.
  SlowOutputs outputs() const noexcept { return model_.outputs(time_s_, inputs_, state_); }

  const SlowState& state() const noexcept { return state_; }
  const TurbineParams& params() const noexcept { return model_.params(); }
  const OdeSolver::Statistics& statistics() const { return solver_.statistics(); }

 private:
  struct Problem {
    const SlowModel* model;
    const SlowInputs* inputs;
  };
  static void evaluate(double time_s, const double* state, double* rates, const void* problem);

  SlowModel model_;
  OdeSolver solver_;
  SlowState state_{};
  SlowInputs inputs_{};
  double time_s_ = 0.0;
};

}  // namespace lac::sim
