// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/signal_intensity.hpp"

#include <array>
#include <cmath>

namespace lac {

SignalIntensity::State SignalIntensity::initial_state() const {
  State s;
  if (params_.used) s.window = SpeedStatistics(params_.statistics);
  return s;
}

const IntensityEstimate& SignalIntensity::step(double speed_mps, double time_s,
                                               State& state) const noexcept {
  if (!params_.used) return state.estimate;
  const bool left = state.window.expire(time_s) >= 0;
  const bool due = time_s >= state.next_sample_s - SampleWindow::kTolerance_s;
  if (due) {
    state.next_sample_s = time_s + params_.statistics.scan_time_s;
    if (RunningMoments::fits(speed_mps)) {
      const std::array<std::int32_t, 1> row{RunningMoments::quantise(speed_mps)};
      state.window.add(time_s, 0, row);
    }
  }
  if (left || due) state.estimate = estimate(time_s, state);
  return state.estimate;
}

IntensityEstimate SignalIntensity::estimate(double time_s, const State& state) const noexcept {
  if (!state.window.has_lasted(time_s)) return {};
  const SpeedStatistics::Series s = state.window.series(0, 0, time_s);
  if (!s.filled || !(s.mean_mps > 0.0)) return {};
  const double ratio = s.standard_deviation_mps / s.mean_mps;
  const double left = ratio * ratio - params_.added_intensity * params_.added_intensity;
  if (!(left > 0.0)) return {};
  const double free_mps = params_.speed_factor * s.mean_mps;
  const std::vector<double>& known_mps = params_.correction.x();
  const bool inside = free_mps >= known_mps.front() && free_mps <= known_mps.back();
  if (known_mps.size() > 1 && !inside) return {};
  return {params_.correction.at(free_mps) * std::sqrt(left), free_mps};
}

}  // namespace lac
