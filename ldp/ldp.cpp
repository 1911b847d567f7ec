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

std::int64_t round_to_step(double time_s, double time_step_s) {
  return std::llround(time_s / time_step_s);
}

}  // namespace

Ldp::Ldp(LdpParams params, double time_step_s)
    : params_(std::move(params)),
      time_step_s_(time_step_s),
      window_steps_(std::max<std::int64_t>(1, round_to_step(params_.scan_time_s, time_step_s))) {}

Ldp::State Ldp::initial_state() const {
  State s;
  s.bins = ArrivalBins(static_cast<std::size_t>(std::ceil(params_.longest_lead_s / time_step_s_)) +
                       static_cast<std::size_t>(window_steps_) + 2);
  const auto beams = static_cast<std::size_t>(params_.reader.number_of_beams);
  s.nearest_of_beam_m.assign(beams, 0.0);
  s.last_of_beam_s.assign(beams, std::numeric_limits<double>::quiet_NaN());
  return s;
}

Ldp::Projection Ldp::projection(const LidarMeasurement& m) const noexcept {
  const Vec3 n_I = params_.motion_compensation
                       ? m.beam_dir_I()
                       : Vec3{-m.beam_dir_L.x, -m.beam_dir_L.y, m.beam_dir_L.z};
  const double own_mps = params_.motion_compensation ? dot(n_I, m.velocity_I_mps) : 0.0;
  return {n_I.x, own_mps, 1.0 / -n_I.x};
}

void Ldp::update_mean_speed(const LidarMeasurement& m, const Projection& p,
                            State& state) const noexcept {
  double sum = 0.0;
  int count = 0;
  for (int g = 0; g < m.gate_count; ++g) {
    const LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    if (!gate.valid) continue;
    sum += p.longitudinal_mps(gate.speed_mps);
    ++count;
  }
  if (count == 0) return;
  const double since_s =
      state.mean_speed.started()
          ? std::clamp(m.time_s - state.last_measurement_s, time_step_s_, params_.scan_time_s)
          : time_step_s_;
  state.mean_speed.add(sum / count, since_s, params_.mean_speed_window_s);
  state.last_measurement_s = m.time_s;
}

void Ldp::take_in(const Inputs& in, State& state) const noexcept {
  const LidarMeasurement& m = *in.measurement;
  const Projection p = projection(m);
  update_mean_speed(m, p, state);
  if (!state.mean_speed.started()) return;
  const double travel_mps = state.mean_speed.mean();
  if (travel_mps < kSlowestTravel_mps) return;

  note_scan(m, state);
  const auto late = round_to_step(in.time_s - m.time_s, time_step_s_);
  state.latency_s = late > 0 ? static_cast<double>(late) * time_step_s_ : 0.0;
  const double allowed_m = nearest_allowed_m(in, state);
  const double for_nearer = settled(state) ? kNearerGate : 1.0;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int g = 0; g < m.gate_count; ++g) {
    const LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    const double ahead_m = -(m.position_I_m.x + gate.range_m * p.beam_x_I);
    const bool in_use = ahead_m > state.nearest_gate_m - kSameGate_m;
    if (!(ahead_m > 0.0) || ahead_m < (in_use ? 1.0 : for_nearer) * allowed_m) continue;
    nearest_m = std::min(nearest_m, ahead_m);
    if (!gate.valid) continue;
    const auto arrival = round_to_step(m.time_s + ahead_m / travel_mps, time_step_s_);
    if (state.bins.add(arrival, p.longitudinal_mps(gate.speed_mps))) {
      state.last_sample_s = in.time_s;
    }
  }
  if (!std::isfinite(nearest_m)) return;
  state.nearest_of_beam_m[static_cast<std::size_t>(m.beam_id)] = nearest_m;
  state.nearest_gate_m = *std::ranges::max_element(state.nearest_of_beam_m);
}

double Ldp::nearest_allowed_m(const Inputs& in, const State& state) const noexcept {
  const double needed_s = in.lead_needed_s > 0.0 ? in.lead_needed_s + params_.lead_margin_s : 0.0;
  const double lead_s = std::max(params_.required_lead_s, needed_s);
  return (lead_s + state.latency_s) * state.mean_speed.mean();
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

Ldp::Outputs Ldp::step(const Inputs& in, State& state) const noexcept {
  const std::int64_t now = round_to_step(in.time_s, time_step_s_);
  state.bins.advance(now);
  if (in.measurement != nullptr) take_in(in, state);

  Outputs out;
  out.data_age_s = in.time_s - state.last_sample_s;
  out.scan_time_s = state.scan_time_s;
  if (!state.mean_speed.started()) return out;
  out.mean_speed_mps = state.mean_speed.mean();
  if (state.nearest_gate_m <= 0.0 || out.mean_speed_mps < kSlowestTravel_mps) return out;
  out.lead_s = state.nearest_gate_m / out.mean_speed_mps - state.latency_s;
  if (out.lead_s <= 0.0 || out.lead_s > params_.longest_lead_s) return out;

  const std::int64_t front = now + round_to_step(out.lead_s, time_step_s_);
  state.bins.set_window(front - window_steps_ + 1, front);
  out.samples = state.bins.count();
  if (out.samples > 0) out.rews_mps = state.bins.mean_mps();
  out.valid = out.samples >= params_.minimum_samples && out.data_age_s <= params_.maximum_age_s &&
              settled(state);
  return out;
}

}  // namespace lac
