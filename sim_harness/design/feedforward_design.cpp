// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/feedforward_design.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/input_file.hpp"
#include "ffp/ffp.hpp"

namespace lac::sim {
namespace {

// A fit leaves this of the lead, as rounded numbers and wind between the points need a little more.
constexpr double kLeadToSpare_s = 0.1;

std::string how_missed(const CorrelationCurve& curve, CutoffRule rule) {
  const std::vector<double> gain = curve.gain();
  const std::string range = " between " + shortest(curve.frequency_hz(0)) + " Hz, where it is " +
                            shortest(gain.front()) + ", and " +
                            shortest(curve.frequency_hz(gain.size() - 1)) + " Hz, where it is " +
                            shortest(gain.back());
  return rule == CutoffRule::kClosestFit ? "no low-pass with a cut-off inside fits |G_RL|" + range
                                         : "|G_RL| does not fall through -3 dB" + range;
}

/// Between the two frequencies about the cut-off.
double late_at_s(const CorrelationCurve& curve, double cutoff_hz) {
  std::size_t i = 1;
  while (i + 1 < curve.k1_radpm.size() && curve.frequency_hz(i) < cutoff_hz) ++i;
  const std::vector<double> late_s = curve.lateness_s();
  const double before_hz = curve.frequency_hz(i - 1), after_hz = curve.frequency_hz(i);
  return std::lerp(late_s[i - 1], late_s[i], (cutoff_hz - before_hz) / (after_hz - before_hz));
}

bool is_fitted(CutoffRule rule, const FeedforwardTiming& t) {
  return t.filter_order == 2 || rule == CutoffRule::kLeastLeft;
}

/// A fit has what lead the rest leaves to it; without any it is as quick as the curve is long.
LowPassDesign low_pass(const CorrelationCurve& curve, const FeedforwardPoint& p,
                       const FeedforwardTiming& t, CutoffRule rule) {
  if (!is_fitted(rule, t)) return {1, p.cutoff_hz, 0.0};
  const double left_s =
      p.lead_s - p.actuator_s - p.half_window_s + p.trim_s - t.lead_margin_s - kLeadToSpare_s;
  return fit_low_pass(t.filter_order, curve, t.delay_frequency_hz, std::max(left_s, 0.0));
}

Error no_cutoff(const CorrelationCurve& curve, double distance_m, CutoffRule rule) {
  return Error("at " + shortest(curve.mean_speed_mps) + " m/s with gates from " +
               shortest(distance_m) + " m: " + how_missed(curve, rule) +
               "; the lidar sees too little of what the rotor feels, or the range is too short");
}

/// Empty if the gain does not give a cut-off.
std::optional<FeedforwardPoint> point_with(const CorrelationCurve& curve, double distance_m,
                                           CutoffRule rule, const FeedforwardTiming& t) {
  FeedforwardPoint p;
  p.mean_speed_mps = curve.mean_speed_mps;
  p.nearest_gate_m = distance_m;
  p.figures = figures_of_merit(curve);
  const std::optional<double>& cutoff =
      rule == CutoffRule::kClosestFit ? p.figures.fitted_cutoff_hz : p.figures.cutoff_hz;
  if (!cutoff) return std::nullopt;
  p.cutoff_hz = *cutoff;
  p.lead_s = distance_m / curve.mean_speed_mps;
  p.actuator_s =
      actuator_delay_s(t.actuator_frequency_hz, t.actuator_damping, t.delay_frequency_hz);
  p.half_window_s = 0.5 * t.scan_time_s;
  p.late_s = late_at_s(curve, p.cutoff_hz);
  p.trim_s = t.buffer_trim_s.at(p.mean_speed_mps) - (t.trim_lateness ? p.late_s : 0.0);
  p.low_pass = low_pass(curve, p, t, rule);
  p.filter_s = delay_s(p.low_pass, t.delay_frequency_hz);
  p.share_left = share_left(curve, p.low_pass, t.delay_frequency_hz);
  p.needed_s = p.filter_s + p.actuator_s + p.half_window_s - p.trim_s;
  return p;
}

FeedforwardPoint design_at(const CorrelationCurves& curves, std::size_t speed,
                           const LidarVolumes& lidar, CutoffRule rule,
                           const FeedforwardTiming& timing) {
  std::optional<FeedforwardPoint> best, without_lead;
  for (std::size_t first = 0; first < lidar.planes.size(); ++first) {
    const CorrelationCurve curve = curves.curve(speed, first);
    const double distance_m = lidar.planes[first].distance_m;
    std::optional<FeedforwardPoint> p = point_with(curve, distance_m, rule, timing);
    // A fit looks for the best set of gates, so one without a cut-off is no candidate.
    if (!p && is_fitted(rule, timing)) continue;
    if (!p) throw no_cutoff(curve, distance_m, rule);
    p->first_plane = first;
    const bool has_lead = p->buffer_s() >= timing.lead_margin_s;
    if (has_lead && !is_fitted(rule, timing)) return *p;
    if (has_lead && (!best || p->share_left < best->share_left)) best = p;
    if (!has_lead && !without_lead) without_lead = p;
  }
  if (best) return *best;
  if (!without_lead) throw no_cutoff(curves.curve(speed), lidar.planes.front().distance_m, rule);
  without_lead->is_usable = false;
  return *without_lead;
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
