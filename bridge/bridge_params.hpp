// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bridge/added_demands.hpp"
#include "bridge/hub_wind_signal.hpp"
#include "bridge/increment.hpp"
#include "core/input_file.hpp"

namespace lac {

/// How the increment reaches the neighbour's pitch demand.
enum class FeedforwardRoute {
  None,         // not at all
  TowerDamper,  // from before it, as tower acceleration for its damper
  Added,        // from behind it, onto its demands
};

/// How the power level reaches the neighbour.
enum class DeratingRoute {
  None,     // not at all
  HubWind,  // from before it, as hub-height wind speed
};

struct BridgeParams {
  FeedforwardRoute feedforward = FeedforwardRoute::None;
  Increment::Params increment;
  // FA_KI of ROSCO, the gain of its tower damper [rad s/m]; for the route tower_damper.
  double tower_damper_gain = 0.0;
  AddedDemands::Params limits;  // for the route added
  DeratingRoute derating = DeratingRoute::None;
  HubWindSignal::Params hub_wind;

  /// Reads all keys, also those of a route not taken, so that one key changes it; refuses unknown
  /// ones, and a ROSCO input (key RoscoInput) that does not fit. Throws lac::Error.
  static BridgeParams read(InputFile& in);

  /// Refuses what makes no sense at this time step. Throws lac::Error with file, line and key.
  void check_time_step(const InputFile& in, double time_step_s) const;
};

}  // namespace lac
