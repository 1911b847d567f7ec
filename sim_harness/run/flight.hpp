// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim_harness/lidar/turbine_state.hpp"
#include "sim_harness/output/recording.hpp"
#include "sim_harness/run/case_file.hpp"
#include "sim_harness/turbine/slow_model.hpp"
#include "sim_harness/wind/rotor_wind.hpp"

namespace lac::sim {

/// Channels of a flight: wind, turbine and demands, as a measurement on the turbine would have
/// them, named as in OpenFAST where it has them.
std::vector<TableChannel> flight_channels();

struct FlightReport {
  /// Called every step with the part of the flight that is done, 0 ... 1.
  std::function<void(double)> on_progress = [](double) {};
  /// Warnings of the controller, each time it returns one.
  std::function<void(double time_s, const std::string& text)> on_warning = [](double, const auto&) {
  };
};

/// What a lidar on board is told. The thrust coefficient is that of the wind that the rotor feels,
/// F_a / (rho/2 pi R^2 (v - x'_T)^2); 0 where that wind blows from behind.
TurbineState turbine_state(const SlowOutputs& outputs, const TurbineParams& turbine,
                           double rotor_wind_mps, double azimuth_rad);

/// Whether a controller may fly in several threads at a time: its library declares itself reentrant
/// (LAC_DISCON_REENTRANT). Throws lac::Error if it cannot be loaded.
bool can_fly_in_threads(const CaseController& controller);

/// Flies one controller of a case: sense, control, advance. Starts in the steady state at the
/// wind of time 0; demands are held over each step, the wind is linear in it. output_root names
/// the files the controller may write. Deterministic. Throws lac::Error when the controller ends
/// the run or something cannot be set up.
Recording fly(const Case& c, const CaseController& controller, const WindField& wind,
              const RotorWind& rotor_wind, const std::filesystem::path& output_root,
              const FlightReport& report);

}  // namespace lac::sim
