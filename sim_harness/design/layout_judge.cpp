// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>

#include "core/units.hpp"
#include "ffp/ffp.hpp"
#include "sim_harness/design/lidar_optimization.hpp"

namespace lac::sim {
namespace {

// Of a walk from low wavenumbers up that looks for the first crossing, in rotor radii.
constexpr double kFirstK1R = 0.1;
constexpr double kLastK1R = 10.0;
constexpr double kStep = 1.35;
constexpr double kTolerance = 1e-7;

/// The first wavenumber at which a falling function passes below zero, 0 if it starts below or
/// never does. Regula falsi (Illinois) over log k1.
double first_fall_radpm(const std::function<double(double)>& f, double radius_m) {
  double low = std::log(kFirstK1R / radius_m), high = low;
  const double last = std::log(kLastK1R / radius_m);
  double at_low = f(std::exp(low)), at_high = at_low;
  if (at_low < 0.0) return 0.0;
  while (at_high >= 0.0) {
    low = high, at_low = at_high;
    high += std::log(kStep);
    if (high > last) return 0.0;
    at_high = f(std::exp(high));
  }
  int side = 0;
  for (int i = 0; i < 60 && high - low > kTolerance; ++i) {
    const double x = (low * at_high - high * at_low) / (at_high - at_low), at = f(std::exp(x));
    if (std::abs(at) < 1e-9) return std::exp(x);
    if (at < 0.0) {
      high = x, at_high = at;
      if (side == -1) at_low *= 0.5;
      side = -1;
    } else {
      low = x, at_low = at;
      if (side == 1) at_high *= 0.5;
      side = 1;
    }
  }
  return std::exp(0.5 * (low + high));
}

}  // namespace

double LayoutJudge::lead_margin_s(const CorrelationModel& model, const LidarVolumes& lidar,
                                  double scan_time_s) const {
  if (!settings_.lead_at_mps) return 0.0;
  const double v = *settings_.lead_at_mps;
  const auto gain_over_limit = [&](double k1_radpm) {
    const RotorLidarSpectra s = model.at(k1_radpm, {v}).front();
    return std::abs(s.s_rl.front()) / s.s_ll.front() - kMinus3dB;
  };
  const double k1_radpm = first_fall_radpm(gain_over_limit, design_.rotor_radius_m);
  if (k1_radpm == 0.0) return -1.0;  // no cut-off, no feedforward
  const FeedforwardTiming& t = design_.timing;
  const double needed_s =
      filter_delay_s(k1_radpm * v / (2.0 * kPi), t.delay_frequency_hz) +
      actuator_delay_s(t.actuator_frequency_hz, t.actuator_damping, t.delay_frequency_hz) +
      0.5 * scan_time_s - t.buffer_trim_s.at(v) + t.lead_margin_s;
  return lidar.planes.front().distance_m / v - needed_s;
}

LayoutFigures LayoutJudge::figures(const LidarLayout& layout) const {
  return figures(with_layout(design_.lidar, layout));
}

LayoutFigures LayoutJudge::figures(const LidarParams& lidar) const {
  const LidarVolumes volumes = lidar_volumes(lidar, design_.volumes);
  const std::unique_ptr<CorrelationModel> model = make_correlation(design_, volumes);
  const auto coherence_over_half = [&](double k1_radpm) {
    const RotorLidarSpectra s = model->at(k1_radpm, {settings_.wind_speed_mps}).front();
    return std::norm(s.s_rl.front()) / (s.s_rr * s.s_ll.front()) - 0.5;
  };
  return {first_fall_radpm(coherence_over_half, design_.rotor_radius_m),
          lead_margin_s(*model, volumes, lidar.scan.scan_time_s()),
          settings_.largest_half_angle_rad - largest_half_angle_rad(lidar),
          lowest_gate_m(lidar, design_.hub_height_m) - settings_.lowest_gate_m};
}

}  // namespace lac::sim
