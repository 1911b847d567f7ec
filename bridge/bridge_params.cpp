// SPDX-License-Identifier: Apache-2.0
#include "bridge/bridge_params.hpp"

#include <string>

#include "bridge/rosco_input.hpp"
#include "core/units.hpp"

namespace lac {
namespace {

constexpr Range kPitch{-20.0, 120.0};

/// A key that must be there for the route it belongs to; 0 if it is not there for another.
double number_for(bool needed, InputFile& in, const char* key, Range range) {
  return needed ? in.number(key, range) : in.number(key, 0.0, range);
}

void read_increment(InputFile& in, FeedforwardRoute route, Increment::Params& p) {
  p.leak_time_s = in.number("LeakTime", p.leak_time_s, Range::between(0.0, 3600.0));
  p.authority_rad = rad_from_deg(
      number_for(route != FeedforwardRoute::None, in, "Authority", {0.0, 90.0, false}));
  p.fade_time_s = in.number("FadeTime", p.fade_time_s, {0.0, 600.0, false});
  if (route == FeedforwardRoute::Added && p.leak_time_s == 0.0) {
    in.fail("LeakTime",
            "found 0, expected more with FeedforwardRoute added: the controller never sees the "
            "increment, and without a leak its own integrator would stand against it for good");
  }
}

void read_limits(InputFile& in, FeedforwardRoute route, AddedDemands::Params& p) {
  const bool needed = route == FeedforwardRoute::Added;
  p.min_rad = rad_from_deg(number_for(needed, in, "MinimumPitch", kPitch));
  p.max_rad = rad_from_deg(number_for(needed, in, "MaximumPitch", kPitch));
  p.max_rate_radps = rad_from_deg(number_for(needed, in, "MaximumPitchRate", Range::positive()));
  if (needed && p.max_rad <= p.min_rad) {
    in.fail("MaximumPitch", "found " + shortest(deg_from_rad(p.max_rad)) +
                                ", expected more than MinimumPitch, " +
                                shortest(deg_from_rad(p.min_rad)));
  }
}

void read_hub_wind(InputFile& in, HubWindSignal::Params& p) {
  p.rated_mps = in.number("DeratingWindSpeed", p.rated_mps, {0.0, 100.0, false});
  p.max_level = in.number("MaximumPowerLevel", p.max_level, Range::between(1.0, 2.0));
  p.rate_per_s = in.number("PowerLevelRate", p.rate_per_s, Range::positive());
}

}  // namespace

BridgeParams BridgeParams::read(InputFile& in) {
  BridgeParams p;
  p.feedforward = static_cast<FeedforwardRoute>(
      in.choice("FeedforwardRoute", {"none", "tower_damper", "added"}));
  read_increment(in, p.feedforward, p.increment);
  p.tower_damper_gain = number_for(p.feedforward == FeedforwardRoute::TowerDamper, in,
                                   "TowerDamperGain", {0.0, 100.0, false});
  read_limits(in, p.feedforward, p.limits);
  p.derating = static_cast<DeratingRoute>(in.choice("DeratingRoute", 0, {"none", "hub_wind"}));
  read_hub_wind(in, p.hub_wind);
  const std::string rosco = in.text("RoscoInput", "");
  in.finish();
  if (!rosco.empty()) check_rosco_input(in, in.resolve(rosco), p);
  return p;
}

void BridgeParams::check_time_step(const InputFile& in, double time_step_s) const {
  if (increment.fade_time_s < time_step_s) {
    in.fail("FadeTime", "found " + shortest(increment.fade_time_s) +
                            " s, expected at least one step of " + shortest(time_step_s) +
                            " s: it would be a jump");
  }
}

}  // namespace lac
