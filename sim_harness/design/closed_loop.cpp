// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/closed_loop.hpp"

#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "feedback/gain_design.hpp"

namespace lac::sim {
namespace {

constexpr double kAboveRated_mps = 0.5;
constexpr double kAsGood = 1.02;  // a template within this of the design is left alone

double normal_share_above(double mean, double deviation, double limit) {
  return 0.5 * std::erfc((limit - mean) / (deviation * std::sqrt(2.0)));
}

LowPassDesign low_pass_of(const FfpParams& ffp, double mean_speed_mps) {
  if (ffp.filter_order == 1) return {1, ffp.cutoff_hz.at(mean_speed_mps), 0.0};
  return {ffp.filter_order, ffp.cutoff_hz.at(mean_speed_mps), ffp.damping.at(mean_speed_mps)};
}

/// What would help the other tuning most: another time, or the cut-off of the design.
std::string verdict(const RotorSpeedPrediction& p, const FeedforwardTuning& designed,
                    const FeedforwardTuning& other) {
  const auto deviation = [&](const FeedforwardTuning& t) {
    return p.deviation_radps(p.assisted(t));
  };
  if (deviation(other) < kAsGood * deviation(designed)) return "as good";
  const double best_s = p.best_trim_s(other.low_pass);
  if (deviation({other.low_pass, best_s}) < deviation({designed.low_pass, other.trim_s}))
    return best_s < other.trim_s ? "acts too late" : "acts too early";
  return other.low_pass.frequency_hz > designed.low_pass.frequency_hz ? "cut-off too high"
                                                                      : "cut-off too low";
}

ClosedLoopPoint point_of(const RotorSpeedPrediction& p, const FeedforwardPoint& designed,
                         const FfpParams& ffp, double trim_s) {
  ClosedLoopPoint r;
  r.mean_speed_mps = designed.mean_speed_mps;
  r.designed = {designed.low_pass, trim_s};
  r.of_template = {low_pass_of(ffp, r.mean_speed_mps), ffp.buffer_trim_s.at(r.mean_speed_mps)};
  const auto deviation = [&](double cutoff_factor, double error_s) {
    FeedforwardTuning other = r.designed;
    other.low_pass.frequency_hz *= cutoff_factor, other.trim_s += error_s;
    return p.deviation_radps(p.assisted(other));
  };
  r.feedback_only = p.deviation_radps(p.feedback_only());
  r.assisted = deviation(1.0, 0.0);
  r.least = p.deviation_radps(p.least());
  r.late = deviation(1.0, kBufferError_s), r.early = deviation(1.0, -kBufferError_s);
  r.half_cutoff = deviation(0.5, 0.0), r.twice_cutoff = deviation(2.0, 0.0);
  r.best_trim_s = p.best_trim_s(r.designed.low_pass);
  r.with_best_trim = deviation(1.0, r.best_trim_s - trim_s);
  r.with_template = p.deviation_radps(p.assisted(r.of_template));
  r.template_verdict = verdict(p, r.designed, r.of_template);
  r.share_above_threshold =
      ffp.entry == EntryRule::Threshold
          ? normal_share_above(r.mean_speed_mps, p.filtered_deviation_mps(r.designed.low_pass),
                               ffp.threshold_mps)
          : std::numeric_limits<double>::quiet_NaN();
  return r;
}

}  // namespace

ClosedLoop predict_closed_loop(const DesignCase& d, const CorrelationCurves& curves,
                               const std::vector<FeedforwardPoint>& points,
                               const LookupTable& pitch_curve) {
  const double lowest_mps = rated_point(design_plant(*d.turbine)).wind_mps + kAboveRated_mps;
  const double sigma_mps = sigma_u_mps(d.turbulence);
  ClosedLoop result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FeedforwardPoint& p = points[i];
    const double v = p.mean_speed_mps;
    if (v < lowest_mps || !p.is_usable) continue;
    const double ratio = ntm_sigma_mps(d.category, v) / sigma_mps;
    const double slope_radspm =
        0.5 * (pitch_curve.at(v + 1.0) - pitch_curve.at(v - 1.0));  // as the wind moves
    const double window_s = d.curves.scan_time_s > 0.0 ? 0.0 : d.timing.scan_time_s;
    result.predictions.emplace_back(LinearTurbine(*d.turbine, d.feedback->params, v),
                                    curves.curve(i, p.first_plane), d.timing, slope_radspm,
                                    window_s, ratio * ratio);
    result.points.push_back(point_of(result.predictions.back(), p, d.ffp, p.trim_s));
    result.points.back().speed = i;
  }
  return result;
}

}  // namespace lac::sim
