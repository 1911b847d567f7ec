// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/flown_lidar_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/units.hpp"
#include "ffp/ffp.hpp"
#include "sim_harness/design/figures_of_merit.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/csv_table.hpp"

namespace lac::sim {
namespace {

constexpr double kConfidence = 0.95;
constexpr double kLeastCoherence = 0.1;
constexpr double kLargestLateness_s = 10.0, kLagStep_s = 0.01;

std::size_t speed_of(const CorrelationCurves& curves, double speed_mps) {
  const auto& speeds = curves.speeds_mps();
  const auto place = std::ranges::find(speeds, speed_mps);
  if (place == speeds.end()) {
    throw Error("flown_lidar: runs at " + shortest(speed_mps) +
                " m/s, expected only speeds of wind_speeds_mps");
  }
  return static_cast<std::size_t>(place - speeds.begin());
}

/// Linear over log f; NaN outside of the curve.
class Coherence {
 public:
  explicit Coherence(const CorrelationCurve& curve) : values_(curve.coherence()) {
    for (std::size_t i = 0; i < values_.size(); ++i)
      log_hz_.push_back(std::log(curve.frequency_hz(i)));
  }
  double at(double frequency_hz) const {
    const double x = std::log(frequency_hz);
    if (!(x >= log_hz_.front() && x <= log_hz_.back()))
      return std::numeric_limits<double>::quiet_NaN();
    std::size_t i = 1;
    while (i + 1 < log_hz_.size() && log_hz_[i] < x) ++i;
    return std::lerp(values_[i - 1], values_[i],
                     (x - log_hz_[i - 1]) / (log_hz_[i] - log_hz_[i - 1]));
  }

 private:
  std::vector<double> values_, log_hz_;
};

void compare_coherence(const CorrelationCurve& curve, const CrossSpectrum& flown,
                       LidarComparison& r) {
  const Coherence model(curve);
  const Band band = coherence_band(flown.coherence, flown.independent_blocks, kConfidence);
  double sum = 0.0;
  for (std::size_t i = 0; i < flown.frequency_hz.size(); ++i) {
    const double expected = model.at(flown.frequency_hz[i]);
    if (!(expected >= kLeastCoherence)) continue;
    ++r.compared;
    if (expected >= band.low[i] && expected <= band.high[i]) ++r.inside;
    sum += flown.coherence[i] - expected;
  }
  r.mean_difference = sum / r.compared;
  const double to_k1 = 2.0 * kPi / curve.mean_speed_mps;
  r.flown_k05_radpm = to_k1 * first_fall_hz(flown.frequency_hz, flown.coherence, 0.5);
  r.model_k05_radpm =
      figures_of_merit(curve).k05_radpm.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// Where the cross-correlation of rotor and estimate peaks: the lag with the largest sum over
/// frequency of Re S_RL e^(-i 2 pi f lag).
double peak_lateness_s(const CorrelationCurve& c) {
  double best_s = 0.0, most = 0.0;
  for (double lag_s = -kLargestLateness_s; lag_s <= kLargestLateness_s; lag_s += kLagStep_s) {
    double sum = 0.0;
    for (std::size_t i = 1; i < c.k1_radpm.size(); ++i) {
      const auto turned = [&](std::size_t j) {
        return std::real(c.s_rl[j] * std::polar(1.0, -radps_from_hz(c.frequency_hz(j)) * lag_s));
      };
      sum += 0.5 * (turned(i) + turned(i - 1)) * (c.frequency_hz(i) - c.frequency_hz(i - 1));
    }
    if (sum > most) most = sum, best_s = lag_s;
  }
  return best_s;
}

}  // namespace

std::vector<LidarComparison> compare_flown_lidar(const DesignCase& d, const LidarVolumes& lidar,
                                                 const CorrelationCurves& curves,
                                                 const std::vector<FlownLidar>& flown) {
  std::vector<LidarComparison> rows;
  for (const FlownLidar& f : flown) {
    const double v = f.mean_speed_mps;
    LidarComparison r;
    r.mean_speed_mps = v;
    r.runs = f.runs;
    r.independent_blocks = f.spectrum.independent_blocks;
    compare_coherence(curves.curve(speed_of(curves, v)), f.spectrum, r);
    r.flown_delay_s = f.delay_s, r.lead_s = f.lead_s;
    r.expected_s = lidar.planes.front().distance_m / v - 0.5 * d.timing.scan_time_s;
    r.model_delay_s = r.expected_s - peak_lateness_s(curves.curve(speed_of(curves, v)));
    r.filter_s = filter_delay_s(v * r.model_k05_radpm / (2.0 * kPi), d.timing.delay_frequency_hz);
    rows.push_back(r);
  }
  return rows;
}

std::string flown_lidar_table(const std::vector<LidarComparison>& rows) {
  TextTable table({"wind [m/s]", "runs", "blocks", "inside 95 %", "mean difference",
                   "k0.5 flown [rad/m]", "model", "delay flown [s]", "model", "distance/U",
                   "by LDP", "filter at k0.5 [s]", "enough"});
  int inside = 0, compared = 0;
  for (const LidarComparison& r : rows) {
    table.add_row({format_value(r.mean_speed_mps, 1), std::to_string(r.runs),
                   format_value(r.independent_blocks, 0),
                   std::to_string(r.inside) + " of " + std::to_string(r.compared),
                   format_value(r.mean_difference, 3), format_value(r.flown_k05_radpm, 4),
                   format_value(r.model_k05_radpm, 4), format_value(r.flown_delay_s, 2),
                   format_value(r.model_delay_s, 2), format_value(r.expected_s, 2),
                   format_value(r.lead_s, 2), format_value(r.filter_s, 2),
                   r.is_enough() ? "yes" : "no"});
    inside += r.inside, compared += r.compared;
  }
  return "lidar and rotor as flown, beside the model:\n" + table.text() +
         "coherence of the model " +
         "inside the 95 % band of the flown one: " + std::to_string(inside) + " of " +
         std::to_string(compared) + " frequencies\n";
}

std::string flown_coherence_csv(const CorrelationCurves& curves,
                                const std::vector<FlownLidar>& flown) {
  std::string text = csv_line(
      {"mean_speed [m/s]", "frequency [Hz]", "model [-]", "flown [-]", "low [-]", "high [-]"});
  for (const FlownLidar& f : flown) {
    const Coherence model(curves.curve(speed_of(curves, f.mean_speed_mps)));
    const CrossSpectrum& s = f.spectrum;
    const Band band = coherence_band(s.coherence, s.independent_blocks, kConfidence);
    for (std::size_t i = 0; i < s.frequency_hz.size(); ++i) {
      text += csv_line({csv_number(f.mean_speed_mps), csv_number(s.frequency_hz[i]),
                        csv_number(model.at(s.frequency_hz[i])), csv_number(s.coherence[i]),
                        csv_number(band.low[i]), csv_number(band.high[i])});
    }
  }
  return text;
}

}  // namespace lac::sim
