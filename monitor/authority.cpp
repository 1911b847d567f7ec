// SPDX-License-Identifier: Apache-2.0
#include "monitor/authority.hpp"

#include <algorithm>
#include <cmath>

namespace lac {
namespace {

/// 0 at `off` and below, 1 from `on` on. Not a number counts as 1: not known.
double rising(double value, double off, double on) noexcept {
  return std::isnan(value) ? 1.0 : std::clamp((value - off) / (on - off), 0.0, 1.0);
}
/// 1 up to the tolerance, 0 from twice of it on.
double falling(double size, double tolerance) noexcept {
  return rising(-size, -2.0 * tolerance, -tolerance);
}

/// Of the logarithm of the ratio; means of other sign differ by all.
double difference(double mean_ratio) noexcept {
  if (mean_ratio <= 0.0) return std::numeric_limits<double>::infinity();
  return std::abs(std::log(mean_ratio));
}

}  // namespace

const char* text_of(MonitorReason reason) {
  switch (reason) {
    case MonitorReason::Agree:
      return "lidar and rotor agree";
    case MonitorReason::NoLidar:
      return "no valid lidar wind speed";
    case MonitorReason::NoTurbine:
      return "no wind speed from turbine data";
    case MonitorReason::Learning:
      return "not compared long enough";
    case MonitorReason::LowCoherence:
      return "lidar and rotor have too little in common";
    case MonitorReason::WrongDelay:
      return "the feedforward acts at the wrong time";
    case MonitorReason::WrongGain:
      return "the rotor does not follow what the feedforward acts on";
    case MonitorReason::WrongMean:
      return "the mean wind speeds of lidar and rotor differ";
  }
  return "unknown";
}

Authority::Opinion Authority::judge(const Evidence& e) const noexcept {
  if (!e.lidar_valid) return {e.learned ? 0.0 : params_.unknown, MonitorReason::NoLidar};
  if (!e.learned) {
    return {params_.unknown, e.turbine_valid ? MonitorReason::Learning : MonitorReason::NoTurbine};
  }
  const Opinion opinions[] = {
      {rising(e.coherence, params_.coherence_off, params_.coherence_on),
       MonitorReason::LowCoherence},
      {falling(std::abs(e.late_s), params_.delay_tolerance_s), MonitorReason::WrongDelay},
      {rising(e.gain, params_.gain_off, params_.gain_on), MonitorReason::WrongGain},
      {falling(difference(e.mean_ratio), params_.mean_tolerance), MonitorReason::WrongMean}};
  Opinion least{1.0, MonitorReason::Agree};
  for (const Opinion& o : opinions) {
    if (o.share < least.share) least = o;
  }
  return least;
}

void Authority::step(const Evidence& evidence, double elapsed_s, State& s) const noexcept {
  const Opinion now = judge(evidence);
  const bool at_end = now.share == 0.0 || now.share == 1.0;
  if (at_end || now.reason != s.reason || std::abs(now.share - s.target) > params_.hysteresis) {
    s.target = now.share;
    s.reason = now.reason;
  }
  s.value = std::clamp(s.target, s.value - elapsed_s / params_.fall_time_s,
                       s.value + elapsed_s / params_.rise_time_s);
}

}  // namespace lac
