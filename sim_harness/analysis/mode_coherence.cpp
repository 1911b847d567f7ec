// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/mode_coherence.hpp"

#include <algorithm>
#include <cmath>

#include "sim_harness/analysis/statistics.hpp"

namespace lac::sim {
namespace {

DecayFit decay_over(const CrossSpectrum& s, double travel_s) {
  return fit_decay(s.frequency_hz, s.coherence, s.density_x, travel_s, s.frequency_hz.back());
}

}  // namespace

double ModeCoherence::fall_hz(double level) const {
  return first_fall_hz(spectrum.frequency_hz, spectrum.coherence, level);
}

DecayFit ModeCoherence::decay(double range_m) const {
  return decay_over(spectrum, range_m / speed_mps);
}

DecayFit ModeCoherence::scaled_decay(double range_m) const {
  return decay_over(spectrum, range_m * sigma_mps / (speed_mps * speed_mps));
}

std::optional<ModeCoherence> mode_coherence(const InflowSeries& s, OperatingMode mode,
                                            double delay_s, const ModeRule& rule, double block_s) {
  const auto block = static_cast<std::size_t>(std::lround(block_s / s.time_step_s));
  CrossSpectrumEstimator estimator(s.time_step_s, block);
  const auto shift = static_cast<std::size_t>(std::lround(std::max(delay_s, 0.0) / s.time_step_s));
  if (shift >= s.wind.size()) return std::nullopt;
  const std::size_t n = s.wind.size() - shift;
  const auto wind = std::span(s.wind).first(n);
  const auto load = std::span(s.load).subspan(shift);
  std::vector<double> used;
  for (const Stretch& part : stretches_in(mode, rule, std::span(s.power).first(n),
                                          std::span(s.pitch).first(n), wind, load, block)) {
    const auto piece = wind.subspan(part.first, part.length);
    estimator.add(piece, load.subspan(part.first, part.length));
    used.insert(used.end(), piece.begin(), piece.end());
  }
  if (estimator.blocks() < 2) return std::nullopt;
  const Statistics of_wind = statistics(used);
  return ModeCoherence{estimator.result(), estimator.blocks(), of_wind.mean,
                       of_wind.standard_deviation};
}

}  // namespace lac::sim
