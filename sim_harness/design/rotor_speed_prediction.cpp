// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/rotor_speed_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "ffp/ffp.hpp"
#include "sim_harness/analysis/golden_section.hpp"

namespace lac::sim {
namespace {

constexpr double kLargestTrim_s = 3.0;
constexpr int kSections = 40;

double sinc(double x) {
  return std::abs(x) < 1e-9 ? 1.0 : std::sin(kPi * x) / (kPi * x);
}

}  // namespace

RotorSpeedPrediction::RotorSpeedPrediction(const LinearTurbine& turbine,
                                           const CorrelationCurve& curve,
                                           const FeedforwardTiming& timing, double slope_radspm,
                                           double window_s, double scale)
    : timing_(timing) {
  for (std::size_t i = 0; i < curve.k1_radpm.size(); ++i) {
    const double f_hz = curve.frequency_hz(i);
    const LinearTurbine::RotorSpeed g = turbine.rotor_speed(f_hz);
    frequency_hz_.push_back(f_hz);
    s_rr_.push_back(scale * curve.s_rr[i]);
    s_ll_.push_back(scale * curve.s_ll[i]);
    s_rl_.push_back(scale * curve.s_rl[i]);
    per_wind_.push_back(g.per_wind);
    window_gain_.push_back(sinc(f_hz * window_s));
    per_estimate_.push_back(g.per_feedforward * slope_radspm * window_gain_.back());
  }
}

std::vector<double> RotorSpeedPrediction::feedback_only() const {
  std::vector<double> density;
  for (std::size_t i = 0; i < s_rr_.size(); ++i)
    density.push_back(std::norm(per_wind_[i]) * s_rr_[i]);
  return density;
}

std::vector<double> RotorSpeedPrediction::assisted(const FeedforwardTuning& t) const {
  const double ahead_s = delay_s(t.low_pass, timing_.delay_frequency_hz) +
                         actuator_delay_s(timing_.actuator_frequency_hz, timing_.actuator_damping,
                                          timing_.delay_frequency_hz) -
                         t.trim_s;
  std::vector<double> density;
  for (std::size_t i = 0; i < s_rr_.size(); ++i) {
    const double f_hz = frequency_hz_[i];
    const std::complex<double> g =
        per_estimate_[i] * std::polar(gain_of(t.low_pass, f_hz),
                                      radps_from_hz(f_hz) * (ahead_s - delay_s(t.low_pass, f_hz)));
    density.push_back(std::norm(per_wind_[i]) * s_rr_[i] + std::norm(g) * s_ll_[i] +
                      2.0 * std::real(per_wind_[i] * std::conj(g) * s_rl_[i]));
  }
  return density;
}

std::vector<double> RotorSpeedPrediction::least() const {
  std::vector<double> density;
  for (std::size_t i = 0; i < s_rr_.size(); ++i) {
    density.push_back(std::norm(per_wind_[i]) * (s_rr_[i] - std::norm(s_rl_[i]) / s_ll_[i]));
  }
  return density;
}

double RotorSpeedPrediction::variance(const std::vector<double>& density, double from_hz,
                                      double to_hz) const {
  double sum = 0.0;
  for (std::size_t i = 1; i < density.size(); ++i) {
    const double a = frequency_hz_[i - 1], b = frequency_hz_[i];
    const double low = std::clamp(from_hz, a, b), high = std::clamp(to_hz, a, b);
    const double middle = 0.5 * (low + high);
    sum += (high - low) * std::lerp(density[i - 1], density[i], (middle - a) / (b - a));
  }
  return sum;
}

double RotorSpeedPrediction::deviation_radps(const std::vector<double>& density) const {
  return std::sqrt(variance(density, frequency_hz_.front(), frequency_hz_.back()));
}

double RotorSpeedPrediction::best_trim_s(const LowPassDesign& low_pass) const {
  return golden_section(-kLargestTrim_s, kLargestTrim_s, kSections, [&](double e) {
    return deviation_radps(assisted({low_pass, e}));
  });
}

double RotorSpeedPrediction::filtered_deviation_mps(const LowPassDesign& low_pass) const {
  std::vector<double> density;
  for (std::size_t i = 0; i < s_ll_.size(); ++i) {
    const double gain = window_gain_[i] * gain_of(low_pass, frequency_hz_[i]);
    density.push_back(gain * gain * s_ll_[i]);
  }
  return deviation_radps(density);
}

}  // namespace lac::sim
