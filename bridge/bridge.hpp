// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bridge/added_demands.hpp"
#include "bridge/bridge_params.hpp"
#include "bridge/hub_wind_signal.hpp"
#include "bridge/increment.hpp"
#include "bridge/tower_signal.hpp"

namespace lac {

/// Gives feedforward and power level of the chain to a feedback controller that does not know the
/// chain. Increment says what pitch is given, TowerSignal and AddedDemands how; HubWindSignal
/// stands for the power level.
class Bridge {
 public:
  static constexpr int kPatience = 10;  // steps without a new demand before it is said

  struct Inputs {
    double rate_radps = 0.0;  // FeedforwardPitchRate
    double active = 0.0;      // FeedforwardActive; not above 0: the feedforward is off
    bool good = true;         // ChainInputsGood
    double nacelle_direction_rad = 0.0;
    double pitch_rad = 0.0;           // measured
    AddedDemands::Demands demands{};  // as the neighbour wrote them [rad]
    double power_level = 1.0;
    double yaw_error_rad = 0.0;
  };
  struct Outputs {
    double increment_rad = 0.0;
    bool limited = false;
    TowerSignal::Outputs tower;       // to be written with the route tower_damper
    AddedDemands::Demands demands{};  // to be written with the route added
    double hub_wind_mps = 0.0;        // to be written with the route hub_wind
  };
  /// What the step noticed; each is true in one step only.
  struct Events {
    bool rate_lost = false;       // active, but the rate is not a number
    bool nobody_writes = false;   // added: no new demand for kPatience steps
    bool nobody_follows = false;  // added: the measured pitch does not show the increment
    bool level_lost = false;      // valid, but not within 0 and MaximumPowerLevel
  };
  struct State {
    Increment::State increment;
    TowerSignal::State tower;
    AddedDemands::State added;
    HubWindSignal::State hub_wind;
    bool rate_is_lost = false;
    double followed_rad2s = 0.0;  // integral of the part of the increment the pitch shows ...
    double given_rad2s = 0.0;     // ... and of its square, until that is judged
    void visit(StateArchive& a) {
      a(increment), a(tower), a(added), a(hub_wind), a(rate_is_lost);
      a(followed_rad2s), a(given_rad2s);
    }
  };

  Bridge(const BridgeParams& params, double time_step_s);
  Outputs step(const Inputs& in, State& state, Events& events) const noexcept;

 private:
  void give_feedforward(const Inputs& in, State& s, Outputs& out, Events& events) const noexcept;
  void give_power_level(const Inputs& in, State& s, Outputs& out, Events& events) const noexcept;
  void add(const Inputs& in, State& s, Outputs& out, Events& events) const noexcept;
  bool is_ignored(const Inputs& in, double increment_rad, State& s) const noexcept;

  FeedforwardRoute feedforward_;
  DeratingRoute derating_;
  Increment increment_;
  TowerSignal tower_;
  AddedDemands added_;
  HubWindSignal hub_wind_;
  double time_step_s_;
};

}  // namespace lac
