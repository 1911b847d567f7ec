// SPDX-License-Identifier: Apache-2.0
// From one measurement to its longitudinal wind speeds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "ldp/ldp.hpp"

namespace lac {
namespace {

constexpr double kLeastInduction = 0.2;  // less of the wind left by the model: no sample
// No place or speed of a wind measurement: a broken record, which would outlast it in running sums.
constexpr double kFarthest_m = 1.0e4;
constexpr double kFastest_mps = 200.0;
// Without measurements for so many scans the neighbours of a sample in time are none.
constexpr double kSilentScans = 5.0;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::size_t place(const LidarMeasurement& m, std::size_t gate) {
  return static_cast<std::size_t>(m.beam_id) * native_lidar::kMaxGates + gate;
}

double plausible(double wind_mps) {
  return std::abs(wind_mps) < kFastest_mps ? wind_mps : kNone;
}

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  int count = 0;
  for (const double v : values) {
    if (std::isnan(v)) continue;
    sum += v;
    ++count;
  }
  return count > 0 ? sum / count : kNone;
}

}  // namespace

Ldp::Projection Ldp::projection(const LidarMeasurement& m) const noexcept {
  const Vec3 n_I = params_.motion_compensation
                       ? m.beam_dir_I()
                       : Vec3{-m.beam_dir_L.x, -m.beam_dir_L.y, m.beam_dir_L.z};
  const double own_mps = params_.motion_compensation ? dot(n_I, m.velocity_I_mps) : 0.0;
  return {n_I, own_mps, 1.0 / -n_I.x};
}

void Ldp::project(const LidarMeasurement& m, const Projection& p, Winds& wind_mps,
                  State& state) const noexcept {
  const auto gates = static_cast<std::size_t>(m.gate_count);
  int expected = 0, usable = 0;
  for (std::size_t g = 0; g < gates; ++g) {
    const LidarGate& gate = m.gates[g];
    wind_mps[g] = gate.valid ? plausible(p.longitudinal_mps(gate.speed_mps)) : kNone;
    if (params_.reader.in_range(gate.range_m)) ++expected;
    if (!std::isnan(wind_mps[g])) ++usable;
  }
  if (m.time_s - state.last_measurement_s > kSilentScans * params_.scan_time_s) {
    spikes_.forget(state.spikes);
  }
  if (spikes_.active()) usable -= spikes_.clean({wind_mps.data(), gates}, state.spikes);
  if (expected > 0) state.availability.count(static_cast<double>(usable) / expected);
}

WindReconstruction::Sample Ldp::sample(const LidarMeasurement& m, std::size_t g,
                                       const Projection& p, State& state) const noexcept {
  const double hub_m =
      reconstruction_.active() ? params_.wind.hub_height_m : params_.induction.hub_height_m;
  const std::vector<double>& weights = params_.wind.gate_weights;
  WindReconstruction::Sample s;
  s.beam_dir_I = p.beam_dir_I;
  s.from_hub_I_m = m.position_I_m + m.gates[g].range_m * p.beam_dir_I - Vec3{0.0, 0.0, hub_m};
  s.los_mps = m.gates[g].speed_mps - p.own_motion_mps;
  if (!weights.empty()) s.weight = g < weights.size() ? weights[g] : 0.0;
  if (!(dot(s.from_hub_I_m, s.from_hub_I_m) < kFarthest_m * kFarthest_m)) {
    s.induction = kNone;
  } else if (induction_.active()) {
    s.induction = induction_.remaining(place(m, g), p.beam_dir_I, s.from_hub_I_m, state.induction);
  }
  return s;
}

void Ldp::correct(const LidarMeasurement& m, const Projection& p, Winds& wind_mps,
                  State& state) const noexcept {
  const auto gates = static_cast<std::size_t>(m.gate_count);
  if (induction_.active()) induction_.start(mean_of({wind_mps.data(), gates}), state.induction);
  WindReconstruction::Sums sums;
  for (std::size_t g = 0; g < gates; ++g) {
    if (std::isnan(wind_mps[g])) continue;
    const WindReconstruction::Sample s = sample(m, g, p, state);
    wind_mps[g] = kNone;
    if (!(s.induction > kLeastInduction)) continue;
    wind_mps[g] = plausible(WindReconstruction::axial_mps(s, state.wind.estimate));
    if (reconstruction_.active() && !std::isnan(wind_mps[g])) reconstruction_.add(s, sums);
  }
  if (!reconstruction_.active()) return;
  const double heading_rad =
      params_.motion_compensation ? std::remainder(m.yaw_rad - kPi, 2.0 * kPi) : 0.0;
  reconstruction_.add(sums, {m.time_s, share_s_, params_.scan_time_s, heading_rad}, state.wind);
}

void Ldp::update_mean_speed(const LidarMeasurement& m, const Winds& wind_mps,
                            State& state) const noexcept {
  const double mean_mps = mean_of({wind_mps.data(), static_cast<std::size_t>(m.gate_count)});
  if (std::isnan(mean_mps)) return;
  const double since_s =
      state.mean_speed.started()
          ? std::clamp(m.time_s - state.last_measurement_s, time_step_s_, params_.scan_time_s)
          : time_step_s_;
  state.mean_speed.add(mean_mps, since_s, params_.mean_speed_window_s);
  state.last_measurement_s = m.time_s;
  if (induction_.active()) induction_.add(mean_mps, share_s_, state.induction);
}

}  // namespace lac
