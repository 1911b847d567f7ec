// SPDX-License-Identifier: Apache-2.0
#include "ldp/ldp.hpp"

#include <algorithm>
#include <cmath>

namespace lac {
namespace {

constexpr double kSlowestTravel_mps = 1.0;  // below it a lead time means nothing
// A gate nearer than those in use is taken only with this factor on the required lead, so that the
// nearest gate does not change to and fro with the mean wind speed.
constexpr double kNearerGate = 1.05;
constexpr double kSameGate_m = 2.0;  // the tower top moves
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::int64_t round_to_step(double time_s, double time_step_s) {
  return std::llround(time_s / time_step_s);
}

}  // namespace

Ldp::Ldp(LdpParams params, double time_step_s)
    : params_(std::move(params)),
      time_step_s_(time_step_s),
      window_steps_(std::max<std::int64_t>(1, round_to_step(params_.scan_time_s, time_step_s))),
      share_s_(params_.scan_time_s / params_.reader.number_of_beams),
      expected_{params_.reader.number_of_beams, params_.scan_time_s, params_.availability_window_s},
      reconstruction_(params_.wind),
      induction_(params_.induction),
      spikes_(params_.spikes) {}

Ldp::State Ldp::initial_state() const {
  State s;
  s.bins = ArrivalBins(static_cast<std::size_t>(std::ceil(params_.longest_lead_s / time_step_s_)) +
                       static_cast<std::size_t>(window_steps_) + 2);
  const auto beams = static_cast<std::size_t>(params_.reader.number_of_beams);
  s.nearest_of_beam_m.assign(beams, 0.0);
  s.last_of_beam_s.assign(beams, kNone);
  s.wind = reconstruction_.initial_state();
  s.induction = induction_.initial_state(beams * native_lidar::kMaxGates);
  s.spikes = spikes_.initial_state();
  return s;
}

void Ldp::take_in(const Inputs& in, State& state) const noexcept {
  const LidarMeasurement& m = *in.measurement;
  const Projection p = projection(m);
  Winds wind_mps;
  project(m, p, wind_mps, state);
  if (reconstruction_.active() || induction_.active()) correct(m, p, wind_mps, state);
  update_mean_speed(m, wind_mps, state);
  if (!state.mean_speed.started()) return;
  const double travel = travel_mps(in.time_s, state);
  if (travel < kSlowestTravel_mps) return;

  note_scan(m, state);
  const auto late = round_to_step(in.time_s - m.time_s, time_step_s_);
  state.latency_s = late > 0 ? static_cast<double>(late) * time_step_s_ : 0.0;
  const double allowed_m = nearest_allowed_m(in, state);
  const double for_nearer = settled(state) ? kNearerGate : 1.0;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < static_cast<std::size_t>(m.gate_count); ++g) {
    if (!params_.reader.in_range(m.gates[g].range_m)) continue;
    const double ahead_m = induction_.travel_m(
        -(m.position_I_m.x + m.gates[g].range_m * p.beam_dir_I.x), state.induction);
    const bool in_use = ahead_m > state.nearest_gate_m - kSameGate_m;
    if (!(ahead_m > 0.0) || ahead_m < (in_use ? 1.0 : for_nearer) * allowed_m) continue;
    nearest_m = std::min(nearest_m, ahead_m);
    if (std::isnan(wind_mps[g])) continue;
    const auto arrival = round_to_step(m.time_s + ahead_m / travel, time_step_s_);
    if (state.bins.add(arrival, wind_mps[g])) state.last_sample_s = in.time_s;
  }
  if (!std::isfinite(nearest_m)) return;
  state.nearest_of_beam_m[static_cast<std::size_t>(m.beam_id)] = nearest_m;
  state.nearest_gate_m = *std::ranges::max_element(state.nearest_of_beam_m);
}

double Ldp::nearest_allowed_m(const Inputs& in, const State& state) const noexcept {
  const double needed_s = in.lead_needed_s > 0.0 ? in.lead_needed_s + params_.lead_margin_s : 0.0;
  const double lead_s = std::max(params_.required_lead_s, needed_s);
  return (lead_s + state.latency_s) * travel_mps(in.time_s, state);
}

void Ldp::note_scan(const LidarMeasurement& m, State& state) const noexcept {
  double& last_s = state.last_of_beam_s[static_cast<std::size_t>(m.beam_id)];
  const double since_s = m.time_s - last_s;
  const bool shorter = state.scan_time_s == 0.0 || since_s < state.scan_time_s;
  if (std::isfinite(since_s) && shorter) state.scan_time_s = since_s;
  last_s = m.time_s;
}

bool Ldp::settled(const State& state) const noexcept {
  return state.mean_speed.elapsed_s() >=
         std::min(params_.settling_time_s, params_.mean_speed_window_s);
}

void Ldp::note_turbine(const Inputs& in, State& state) const noexcept {
  if (params_.travel != TravelSpeed::Turbine || !std::isfinite(in.turbine_rews_mps)) return;
  state.turbine_speed.add(in.turbine_rews_mps, time_step_s_, params_.mean_speed_window_s);
  state.turbine_seen_s = in.time_s;
}

bool Ldp::turbine_sets_travel(double time_s, const State& state) const noexcept {
  return params_.travel == TravelSpeed::Turbine &&
         state.turbine_speed.elapsed_s() >= params_.settling_time_s &&
         time_s - state.turbine_seen_s <= params_.mean_speed_window_s;
}

double Ldp::travel_mps(double time_s, const State& state) const noexcept {
  return turbine_sets_travel(time_s, state) ? state.turbine_speed.mean() : state.mean_speed.mean();
}

void Ldp::estimate(const Inputs& in, State& state, Outputs& out) const noexcept {
  out.data_age_s = in.time_s - state.last_sample_s;
  out.scan_time_s = state.scan_time_s;
  if (!state.mean_speed.started()) return;
  out.mean_speed_mps = state.mean_speed.mean();
  const double travel = travel_mps(in.time_s, state);
  if (state.nearest_gate_m <= 0.0 || travel < kSlowestTravel_mps) return;
  out.lead_s = state.nearest_gate_m / travel - state.latency_s;
  if (out.lead_s <= 0.0 || out.lead_s > params_.longest_lead_s) return;

  const std::int64_t front =
      round_to_step(in.time_s, time_step_s_) + round_to_step(out.lead_s, time_step_s_);
  state.bins.set_window(front - window_steps_ + 1, front);
  out.samples = state.bins.count();
  if (out.samples > 0) out.rews_mps = state.bins.mean_mps();
  out.valid = out.samples >= params_.minimum_samples && out.data_age_s <= params_.maximum_age_s &&
              settled(state);
}

void Ldp::bridge(const Inputs& in, State& state, Outputs& out) const noexcept {
  if (out.valid) {
    state.held_rews_mps = out.rews_mps;
    state.held_since_s = in.time_s;
    return;
  }
  if (in.time_s - state.held_since_s > params_.bridged_gap_s || !(out.lead_s > 0.0)) return;
  out.rews_mps = state.held_rews_mps;
  out.valid = out.bridged = true;
}

Ldp::Outputs Ldp::step(const Inputs& in, State& state) const noexcept {
  state.bins.advance(round_to_step(in.time_s, time_step_s_));
  state.availability.advance(in.time_s, expected_);
  note_turbine(in, state);
  if (in.measurement != nullptr) take_in(in, state);

  Outputs out;
  estimate(in, state, out);
  if (params_.bridged_gap_s > 0.0) bridge(in, state, out);
  out.availability = state.availability.value();
  out.turbine_sets_travel = turbine_sets_travel(in.time_s, state);
  if (!reconstruction_.active()) return out;
  reconstruction_.watch(in.time_s, params_.scan_time_s, state.wind);
  out.wind = state.wind.estimate;
  if (out.wind.is_refused() && !params_.wind.average_if_refused) out.valid = out.bridged = false;
  return out;
}

}  // namespace lac
