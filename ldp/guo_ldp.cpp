// SPDX-License-Identifier: Apache-2.0
#include "ldp/guo_ldp.hpp"

#include <algorithm>
#include <cmath>

#include "core/guo_block.hpp"

namespace lac {
namespace {

constexpr double kErrorValueBelow_mps = -90.0;  // -99 plus the lidar's motion
constexpr double kAcrossLimit = 0.05;           // smallest -n_x that can give a wind speed
constexpr double kShortestAge_s = 2.0;
constexpr double kAgeInScans = 2.0;
constexpr double kMeanSpeedWindow_s = 600.0;  // as LdpParams::mean_speed_window_s
const LidarReaderParams kPlausible;

bool is_plausible(double los_mps) {
  return std::isfinite(los_mps) && los_mps > kErrorValueBelow_mps && los_mps != kGuoNoValue &&
         los_mps >= kPlausible.min_speed_mps && los_mps <= kPlausible.max_speed_mps;
}

}  // namespace

GuoLdp::GuoLdp(GuoLdpParams params) : params_(std::move(params)) {}

GuoLdp::State GuoLdp::initial_state() const {
  State s;
  s.wind_mps.assign(static_cast<std::size_t>(params_.samples),
                    std::numeric_limits<double>::quiet_NaN());
  return s;
}

double GuoLdp::longitudinal_mps(const LidarMeasurement& m) const noexcept {
  const bool single = params_.beam_dir_L.size() == 1 || params_.legacy_timing;
  const bool by_id =
      !single || params_.form == GuoLdpParams::Form::V1 || params_.form == GuoLdpParams::Form::V2;
  LidarMeasurement beam;
  beam.beam_dir_L = params_.beam_dir_L[by_id ? static_cast<std::size_t>(m.beam_id) : 0];
  if (params_.motion_compensation) {
    beam.roll_rad = m.roll_rad;
    beam.pitch_rad = m.pitch_rad;
    beam.yaw_rad = m.yaw_rad;
    beam.velocity_I_mps = m.velocity_I_mps;
  }
  const Vec3 n_I = beam.beam_dir_I();
  const double los_mps = m.gates[static_cast<std::size_t>(params_.gate - 1)].speed_mps;
  const double wind_mps = (los_mps - dot(n_I, beam.velocity_I_mps)) / -n_I.x;
  if (params_.legacy_timing) {
    return wind_mps == kGuoNoValue ? std::numeric_limits<double>::quiet_NaN() : wind_mps;
  }
  const bool good = is_plausible(los_mps) && -n_I.x > kAcrossLimit && std::isfinite(wind_mps);
  return good ? wind_mps : std::numeric_limits<double>::quiet_NaN();
}

void GuoLdp::take_in(const Inputs& in, State& s) const noexcept {
  const double wind_mps = longitudinal_mps(*in.measurement);
  if (s.arrivals > 0) {
    const double since_s = in.time_s - s.last_arrival_s;
    if (s.interval_s == 0.0 || since_s < s.interval_s) s.interval_s = since_s;
  }
  s.last_arrival_s = in.time_s;
  s.arrivals = std::min(s.arrivals + 1, params_.samples);
  s.wind_mps[s.next] = wind_mps;
  s.next = s.next + 1 == s.wind_mps.size() ? 0 : s.next + 1;
  if (std::isfinite(wind_mps)) {
    s.last_good_s = in.time_s;
    s.mean_speed.add(wind_mps, std::max(s.interval_s, 1e-3), kMeanSpeedWindow_s);
  }
  double sum_mps = 0.0;
  s.good = 0;
  for (const double u_mps : s.wind_mps) {
    if (std::isnan(u_mps)) continue;
    sum_mps += u_mps;
    ++s.good;
  }
  s.rews_mps = s.good > 0 ? sum_mps / s.good : kGuoNoValue;
}

Ldp::Outputs GuoLdp::step(const Inputs& in, State& s) const noexcept {
  if (in.measurement != nullptr) take_in(in, s);
  Ldp::Outputs out;
  out.samples = s.good;
  out.data_age_s = in.time_s - s.last_good_s;
  out.scan_time_s = s.interval_s * params_.samples;
  if (s.mean_speed.started()) out.mean_speed_mps = s.mean_speed.mean();
  if (params_.legacy_timing) {
    out.rews_mps = s.rews_mps;
    out.valid = s.good > 0;
    return out;
  }
  const double oldest_s = std::max(kShortestAge_s, kAgeInScans * out.scan_time_s);
  if (s.good > 0) out.rews_mps = s.rews_mps;
  out.valid =
      s.arrivals == params_.samples && 2 * s.good >= params_.samples && out.data_age_s <= oldest_s;
  return out;
}

}  // namespace lac
