// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/feedforward_design.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/input_file.hpp"
#include "ffp/ffp.hpp"

namespace lac::sim {
namespace {

std::string how_missed(const CorrelationCurve& curve, CutoffRule rule) {
  const std::vector<double> gain = curve.gain();
  const std::string range = " between " + shortest(curve.frequency_hz(0)) + " Hz, where it is " +
                            shortest(gain.front()) + ", and " +
                            shortest(curve.frequency_hz(gain.size() - 1)) + " Hz, where it is " +
                            shortest(gain.back());
  return rule == CutoffRule::kAtMinus3dB ? "|G_RL| does not fall through -3 dB" + range
                                         : "no low-pass with a cut-off inside fits |G_RL|" + range;
}

/// Between the two frequencies about the cut-off.
double late_at_s(const CorrelationCurve& curve, double cutoff_hz) {
  std::size_t i = 1;
  while (i + 1 < curve.k1_radpm.size() && curve.frequency_hz(i) < cutoff_hz) ++i;
  const std::vector<double> late_s = curve.lateness_s();
  const double before_hz = curve.frequency_hz(i - 1), after_hz = curve.frequency_hz(i);
  return std::lerp(late_s[i - 1], late_s[i], (cutoff_hz - before_hz) / (after_hz - before_hz));
}

FeedforwardPoint point_with(const CorrelationCurve& curve, double distance_m, CutoffRule rule,
                            const FeedforwardTiming& t) {
  FeedforwardPoint p;
  p.mean_speed_mps = curve.mean_speed_mps;
  p.nearest_gate_m = distance_m;
  p.figures = figures_of_merit(curve);
  const auto& cutoff =
      rule == CutoffRule::kAtMinus3dB ? p.figures.cutoff_hz : p.figures.fitted_cutoff_hz;
  if (!cutoff) {
    throw Error("at " + shortest(curve.mean_speed_mps) + " m/s with gates from " +
                shortest(distance_m) + " m: " + how_missed(curve, rule) +
                "; the lidar sees too little of what the rotor feels, or the range is too short");
  }
  p.cutoff_hz = *cutoff;
  p.lead_s = distance_m / curve.mean_speed_mps;
  p.filter_s = filter_delay_s(p.cutoff_hz, t.delay_frequency_hz);
  p.actuator_s =
      actuator_delay_s(t.actuator_frequency_hz, t.actuator_damping, t.delay_frequency_hz);
  p.half_window_s = 0.5 * t.scan_time_s;
  p.late_s = late_at_s(curve, p.cutoff_hz);
  p.needed_s = p.filter_s + p.actuator_s + p.half_window_s - t.buffer_trim_s;
  return p;
}

FeedforwardPoint design_at(const CorrelationCurves& curves, std::size_t speed,
                           const LidarVolumes& lidar, CutoffRule rule,
                           const FeedforwardTiming& timing) {
  for (std::size_t first = 0; first < lidar.planes.size(); ++first) {
    FeedforwardPoint p =
        point_with(curves.curve(speed, first), lidar.planes[first].distance_m, rule, timing);
    p.first_plane = first;
    if (p.buffer_s() >= timing.lead_margin_s) return p;
  }
  FeedforwardPoint p =
      point_with(curves.curve(speed), lidar.planes.front().distance_m, rule, timing);
  p.is_usable = false;
  return p;
}

}  // namespace

std::vector<FeedforwardPoint> design_feedforward(const CorrelationCurves& curves,
                                                 const LidarVolumes& lidar, CutoffRule rule,
                                                 const FeedforwardTiming& timing) {
  std::vector<FeedforwardPoint> points;
  for (std::size_t i = 0; i < curves.speeds_mps().size(); ++i)
    points.push_back(design_at(curves, i, lidar, rule, timing));
  return points;
}

}  // namespace lac::sim
