// SPDX-License-Identifier: Apache-2.0
#include "bridge/bridge.hpp"

#include <cmath>

#include "core/units.hpp"

namespace lac {
namespace {

// Whether the blades follow is judged once, after this much increment (1 deg for 60 s), by the
// share of it that the measured pitch shows: near 1 if they do, near 0 if they do not.
constexpr double kJudgedAfter_rad2s = 60.0 * rad_from_deg(1.0) * rad_from_deg(1.0);
constexpr double kFollowedShare = 0.4;

bool rate_is_lost(const Bridge::Inputs& in) {
  return in.active > 0.0 && !std::isfinite(in.rate_radps);
}

}  // namespace

Bridge::Bridge(const BridgeParams& params, double time_step_s)
    : feedforward_(params.feedforward),
      derating_(params.derating),
      increment_(params.increment, time_step_s),
      tower_(params.tower_damper_gain, time_step_s),
      added_(params.limits, time_step_s),
      hub_wind_(params.hub_wind, time_step_s),
      time_step_s_(time_step_s) {}

Bridge::Outputs Bridge::step(const Inputs& in, State& s, Events& events) const noexcept {
  Outputs out;
  out.demands = in.demands;
  if (feedforward_ != FeedforwardRoute::None) give_feedforward(in, s, out, events);
  if (derating_ != DeratingRoute::None) give_power_level(in, s, out, events);
  return out;
}

void Bridge::give_feedforward(const Inputs& in, State& s, Outputs& out,
                              Events& events) const noexcept {
  const bool lost = rate_is_lost(in);
  events.rate_lost = lost && !s.rate_is_lost;
  s.rate_is_lost = lost;
  const bool on = in.good && in.active > 0.0 && !lost;
  out.limited = increment_.step(on, in.rate_radps, s.increment);
  out.increment_rad = s.increment.pitch_rad;
  if (feedforward_ == FeedforwardRoute::TowerDamper) {
    out.tower = tower_.step(out.increment_rad, in.nacelle_direction_rad, s.tower);
  } else if (in.good) {  // if not, the master holds the demands as they were given last
    add(in, s, out, events);
  }
}

void Bridge::add(const Inputs& in, State& s, Outputs& out, Events& events) const noexcept {
  if (added_.step(out.increment_rad, out.demands, s.added)) out.limited = true;
  events.nobody_writes = s.added.not_written == kPatience;
  events.nobody_follows = is_ignored(in, out.increment_rad, s);
}

bool Bridge::is_ignored(const Inputs& in, double increment_rad, State& s) const noexcept {
  if (s.given_rad2s > kJudgedAfter_rad2s) return false;
  const double shown_rad = in.pitch_rad - static_cast<double>(s.added.base[0]);
  s.followed_rad2s += shown_rad * increment_rad * time_step_s_;
  s.given_rad2s += increment_rad * increment_rad * time_step_s_;
  return s.given_rad2s > kJudgedAfter_rad2s && s.followed_rad2s < kFollowedShare * s.given_rad2s;
}

void Bridge::give_power_level(const Inputs& in, State& s, Outputs& out,
                              Events& events) const noexcept {
  const bool was_refused = s.hub_wind.refused;
  out.hub_wind_mps = hub_wind_.step(in.power_level, in.yaw_error_rad, s.hub_wind);
  events.level_lost = s.hub_wind.refused && !was_refused;
}

}  // namespace lac
