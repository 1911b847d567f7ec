// SPDX-License-Identifier: Apache-2.0
#include "core/openfast_lidar.hpp"

#include <cmath>

namespace lac {

OpenFastLidar::OpenFastLidar(OpenFastLidarParams params) : params_(std::move(params)) {}

bool OpenFastLidar::fetch(const SwapReader& swap, double time_s, State& s, LidarMeasurement& m,
                          Notice& notice) const noexcept {
  if (!is_same_lidar(swap, s, notice)) {
    s.last_call_s = time_s;
    return false;
  }
  const Values now = settled_values(swap, s);
  const bool fresh = is_new(now, s);
  watch(swap, params_.measurement_interval_s == 0.0 || fresh, s, notice);
  if (fresh) {
    m = {};
    m.time_s = params_.measurement_interval_s > 0.0
                   ? static_cast<double>(s.last_interval) * params_.measurement_interval_s
                   : s.last_call_s;
    fill(now, s, m, notice);
  }
  s.started = true;
  s.last_call_s = time_s;
  return fresh;
}

bool OpenFastLidar::is_same_lidar(const SwapReader& swap, State& s, Notice& notice) const noexcept {
  const OpenFastHeader now =
      swap.holds(kOpenFastLidarBlock) ? read_openfast_header(swap) : OpenFastHeader{};
  if (!s.started) s.header = now;
  if (now == s.header && now.points() > 0) return true;
  for (ExtrapolationInverse& inverse : s.speed) inverse.lose();  // until x has settled, too
  if (!s.header_reported) {
    notice.warn(
        "lidar: OpenFAST's block says sensor type %d, %d beams, %d gates, at the start it said "
        "%d, %d, %d: not used until it says so again",
        now.sensor_type, now.beams, now.gates, s.header.sensor_type, s.header.beams,
        s.header.gates);
  }
  s.header_reported = true;
  return false;
}

OpenFastLidar::Values OpenFastLidar::settled_values(const SwapReader& swap,
                                                    State& s) const noexcept {
  Values now;
  const int points = s.header.points();
  for (int i = 0; i < points; ++i) {
    const auto at = static_cast<std::size_t>(i);
    now.speed_mps[at] = s.speed[at].step(openfast_speed(swap, i), params_.interpolation_order);
    now.x_m[at] = s.x[at].step(openfast_x(swap, i, points), params_.interpolation_order);
  }
  return now;
}

bool OpenFastLidar::is_new(const Values& now, State& s) const noexcept {
  if (params_.measurement_interval_s > 0.0) {
    constexpr double kTolerance = 1.0e-6;  // of an interval: times are rounded multiples
    const double passed = s.last_call_s / params_.measurement_interval_s + kTolerance;
    const auto interval = static_cast<std::int64_t>(std::floor(passed));
    const bool due = !s.started || interval > s.last_interval;
    s.last_interval = interval;
    return due;
  }
  bool moved = !s.started;
  for (int i = 0; i < s.header.points(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double speed_mps = now.speed_mps[at];
    if (!std::isfinite(speed_mps)) continue;
    moved = moved || !(std::abs(speed_mps - s.taken_mps[at]) <= OrderWatch::kSettled_mps);
  }
  return moved;
}

void OpenFastLidar::fill(const Values& now, State& s, LidarMeasurement& m,
                         Notice& notice) const noexcept {
  m.gate_count = s.header.points();
  int behind = 0;
  for (int i = 0; i < m.gate_count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double range_m = params_.rotor_position_x_m - now.x_m[at];
    const bool ahead = range_m >= kRotorClearance_m;
    if (range_m < kRotorClearance_m) ++behind;
    m.gates[at].range_m = ahead ? range_m : 0.0;
    m.gates[at].speed_mps = now.speed_mps[at];
    m.gates[at].valid = ahead && std::isfinite(now.speed_mps[at]);
    s.taken_mps[at] = now.speed_mps[at];
  }
  if (behind > 0 && !s.behind_reported) {
    notice.warn(
        "lidar: %d of %d points are at or behind the rotor (less than %g m ahead of "
        "RotorPositionX, %g m) and are not used",
        behind, m.gate_count, kRotorClearance_m, params_.rotor_position_x_m);
    s.behind_reported = true;
  }
}

void OpenFastLidar::watch(const SwapReader& swap, bool scheduled, State& s,
                          Notice& notice) const noexcept {
  double received = 0.0;
  for (int i = 0; i < s.header.points(); ++i) received += openfast_speed(swap, i);
  switch (s.watch.step(received, params_.interpolation_order, scheduled)) {
    case OrderWatch::Finding::None:
      return;
    case OrderWatch::Finding::OtherOrder:
      notice.warn(
          "lidar: InterpolationOrder is %d, but the speeds come as from order %d and so "
          "overshoot at each measurement. Set it to InterpOrder of the .fst file (0 if DLL_DT "
          "is three or more DT)",
          params_.interpolation_order, s.watch.best_order());
      return;
    case OrderWatch::Finding::OtherTimes:
      notice.warn(
          "lidar: speeds change between the multiples of MeasurementInterval, %g s: is it that of "
          "the InflowWind file?",
          params_.measurement_interval_s);
  }
}

}  // namespace lac
