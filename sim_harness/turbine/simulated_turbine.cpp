// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/simulated_turbine.hpp"

namespace lac::sim {

SimulatedTurbine::SimulatedTurbine(const TurbineParams& params)
    : model_(params), solver_(evaluate, 1e-6, {1e-8, 1e-6, 1e-6, 1e-7, 1e-6, 1.0}) {}

void SimulatedTurbine::evaluate(double time_s, const double* state, double* rates,
                                const void* problem) {
  const auto& p = *static_cast<const Problem*>(problem);
  p.model->derivatives(time_s, *p.inputs, state, rates);
}

void SimulatedTurbine::start(const OperatingPoint& point) {
  state_ = state_at(params(), point);
  inputs_ = {point.wind_mps, 0.0, point.pitch_rad, point.generator_torque_Nm};
  time_s_ = 0.0;
}

void SimulatedTurbine::advance(double duration_s, const SlowInputs& inputs) {
  inputs_ = inputs;
  time_s_ = duration_s;
  model_.pass_demands(inputs_, state_);
  const Problem problem{&model_, &inputs_};
  solver_.advance(duration_s, state_.data(), &problem);
}

}  // namespace lac::sim
