// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/correction.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "ti_estimator/disk_coherence.hpp"
#include "ti_estimator/gauss8.hpp"

namespace lac {
namespace {

constexpr int kWindowPeriods = 16;   // the response is followed that far, its mean taken beyond
constexpr double kPanelRatio = 1.8;  // of the frequencies at the ends of a panel
constexpr double kLowestSpeed_mps = 0.5;  // for which Mann's spectra reach far enough

/// Mean of the response over a period of it, for many periods in the window.
double mean_window_response(double periods, Window window, Detrending detrending) {
  if (window == Window::Exponential) return window_response(periods, window, detrending);
  const double x = kPi * periods;
  return 1.0 - (detrending == Detrending::Linear ? 2.0 : 0.5) / (x * x);
}

double three_point_response(double phase_rad, double decay) {
  // Pairs of points 0, W/2 and W apart; phase and decay are those over W/2.
  return 0.375 + 0.5 * std::cos(phase_rad) * std::exp(-decay) +
         0.125 * std::cos(2.0 * phase_rad) * std::exp(-2.0 * decay);
}

/// Position of the interval that holds x, and how far into it x lies.
std::pair<std::size_t, double> interval(const std::vector<double>& axis, double x) noexcept {
  std::size_t i = 0;
  while (i + 2 < axis.size() && x >= axis[i + 1]) ++i;
  if (axis.size() == 1) return {0, 0.0};
  return {i, (x - axis[i]) / (axis[i + 1] - axis[i])};
}

}  // namespace

MannParams iec_mann(double hub_height_m) {
  MannParams p;
  p.alpha_epsilon = 1.0;
  p.length_m = 0.8 * (hub_height_m <= 60.0 ? 0.7 * hub_height_m : 42.0);
  p.gamma = 3.9;
  p.lifetime = EddyLifetime::kMann;
  return p;
}

double window_response(double periods, Window window, Detrending detrending) {
  const double x = kPi * periods;
  if (window == Window::Exponential) return x * x / (1.0 + x * x);
  const double sinc = std::sin(x) / x;
  const double slope = detrending == Detrending::Linear ? (sinc - std::cos(x)) / x : 0.0;
  return 1.0 - sinc * sinc - 3.0 * slope * slope;
}

Vec3 beam_in_wind(const Vec3& beam_L, double yaw_error_rad) {
  const double c = std::cos(yaw_error_rad), s = std::sin(yaw_error_rad);
  return {c * beam_L.x + s * beam_L.y, -s * beam_L.x + c * beam_L.y, beam_L.z};
}

Correction::Correction(const CorrectionParams& params)
    : params_(params),
      volume_std_m_(params.pulse_width_m / std::sqrt(8.0 * std::log(2.0))),
      lidar_nodes_(nodes(params.aliasing ? params.max_frequency_hz : params.scan_rate_hz)),
      point_nodes_(nodes(params.max_frequency_hz)) {
  if (params.spectra == Spectra::Kaimal) return;
  const double highest_hz = std::max(params.max_frequency_hz, params.scan_rate_hz);
  mann_.emplace(scaled_to_sigma_u(params.mann, 1.0), volume_std_m_,
                2.0 * kPi * highest_hz / kLowestSpeed_mps);
  mann_u_ = mann_->u();
}

std::vector<Correction::Node> Correction::nodes(double upper_hz) const {
  const bool response = params_.low_frequencies == LowFrequencies::Response;
  const double lowest_hz = 1.0 / params_.averaging_time_s;
  const double followed_hz = response ? kWindowPeriods * lowest_hz : 0.0;
  std::vector<Node> result;
  double from_hz = response ? 0.0 : lowest_hz;
  while (from_hz < upper_hz) {
    const bool followed = from_hz < followed_hz - 0.5 * lowest_hz;
    const double to_hz = std::min(followed ? from_hz + lowest_hz : from_hz * kPanelRatio, upper_hz);
    const double middle = 0.5 * (from_hz + to_hz), half = 0.5 * (to_hz - from_hz);
    for (const GaussPoint& p : kGauss8) {
      for (const double side : {-1.0, 1.0}) {
        const double f = middle + side * half * p.x;
        result.push_back({f, half * p.weight * (response ? share_left(f, followed) : 1.0)});
      }
    }
    from_hz = to_hz;
  }
  return result;
}

double Correction::share_left(double frequency_hz, bool followed) const {
  const double periods = frequency_hz * params_.averaging_time_s;
  return followed ? window_response(periods, params_.window, params_.detrending)
                  : mean_window_response(periods, params_.window, params_.detrending);
}

double Correction::volume_response(const Vec3& beam_W, double frequency_hz,
                                   double mean_speed_mps) const {
  const double wave_number_radpm = 2.0 * kPi * frequency_hz / mean_speed_mps;
  const double phase_radpm = wave_number_radpm * std::abs(beam_W.x);
  if (params_.volume_model == VolumeModel::Phase) {
    const double phase_rad = volume_std_m_ * phase_radpm;
    return std::exp(-phase_rad * phase_rad);
  }
  const double across = std::hypot(beam_W.y, beam_W.z);
  const double decay_pm = across * params_.model.coherence_rate(frequency_hz, mean_speed_mps);
  if (params_.volume_model == VolumeModel::ThreePoint) {
    const double half_m = 0.5 * params_.pulse_width_m;
    return three_point_response(half_m * phase_radpm, half_m * decay_pm);
  }
  return faddeeva_.real_part(volume_std_m_ * phase_radpm, volume_std_m_ * decay_pm);
}

double Correction::variance(const TabulatedSpectrum& spectrum, const std::vector<Node>& nodes,
                            double mean_speed_mps) {
  const double radpm_per_hz = 2.0 * kPi / mean_speed_mps;
  double sum = 0.0;
  for (const Node& node : nodes)
    sum += node.weight_hz * spectrum.at(radpm_per_hz * node.frequency_hz);
  return 2.0 * radpm_per_hz * sum;  // of both sides of k1
}

double Correction::los_variance(const Vec3& beam_W, double mean_speed_mps) const {
  if (!mann_) return kaimal_variance(beam_W, mean_speed_mps);
  return variance(mann_->los({-beam_W.x, -beam_W.y, beam_W.z}), lidar_nodes_, mean_speed_mps);
}

double Correction::kaimal_variance(const Vec3& beam_W, double mean_speed_mps) const {
  const double lateral = params_.lateral_coherence == LateralCoherence::SameAsU ? 1.0 : 0.0;
  const Vec3 share{beam_W.x * beam_W.x, lateral * beam_W.y * beam_W.y,
                   lateral * beam_W.z * beam_W.z};
  double sum = 0.0;
  for (const Node& node : lidar_nodes_) {
    const double f = node.frequency_hz;
    const Vec3 spectra{params_.model.u.spectrum(f, mean_speed_mps),
                       params_.model.v.spectrum(f, mean_speed_mps),
                       params_.model.w.spectrum(f, mean_speed_mps)};
    sum += node.weight_hz * dot(share, spectra) * volume_response(beam_W, f, mean_speed_mps);
  }
  return sum / (params_.model.u.sigma_mps * params_.model.u.sigma_mps);
}

double Correction::u_variance(double mean_speed_mps) const {
  if (mann_) return variance(mann_u_, point_nodes_, mean_speed_mps);
  const KaimalComponent& u = params_.model.u;
  double variance = 0.0;
  if (params_.low_frequencies == LowFrequencies::Cutoff) {
    variance = u.variance(1.0 / params_.averaging_time_s, params_.max_frequency_hz, mean_speed_mps);
  } else {
    for (const Node& node : point_nodes_) {
      variance += node.weight_hz * u.spectrum(node.frequency_hz, mean_speed_mps);
    }
  }
  return variance / (u.sigma_mps * u.sigma_mps);
}

double Correction::rews_variance(double mean_speed_mps, double rotor_radius_m,
                                 double cutoff_hz) const {
  const KaimalModel& model = params_.model;
  double variance = 0.0;
  for (const Node& node : point_nodes_) {
    const double f = node.frequency_hz, ratio = f / cutoff_hz;
    const double rate_pm = model.coherence_rate(f, mean_speed_mps);
    variance += node.weight_hz * model.u.spectrum(f, mean_speed_mps) *
                disk_coherence(rate_pm * rotor_radius_m) / (1.0 + ratio * ratio);
  }
  return variance / (model.u.sigma_mps * model.u.sigma_mps);
}

double Correction::c_ti(const Vec3& beam_L, double mean_speed_mps, double yaw_error_rad) const {
  return c_ti(beam_L, std::vector{mean_speed_mps}, yaw_error_rad).front();
}

std::vector<double> Correction::c_ti(const Vec3& beam_L, const std::vector<double>& speeds_mps,
                                     double yaw_error_rad) const {
  const Vec3 beam_W = beam_in_wind(beam_L, yaw_error_rad);
  TabulatedSpectrum mann_los;
  if (mann_) mann_los = mann_->los({-beam_W.x, -beam_W.y, beam_W.z});
  std::vector<double> factors;
  for (const double speed_mps : speeds_mps) {
    const double los =
        mann_ ? variance(mann_los, lidar_nodes_, speed_mps) : kaimal_variance(beam_W, speed_mps);
    factors.push_back(std::sqrt(u_variance(speed_mps) / los));
  }
  return factors;
}

CorrectionTable::CorrectionTable(const Correction& correction, const std::vector<Vec3>& beams_L,
                                 std::vector<double> speeds_mps, std::vector<double> yaw_errors_rad)
    : speeds_mps_(std::move(speeds_mps)), yaw_errors_rad_(std::move(yaw_errors_rad)) {
  values_.resize(beams_L.size() * speeds_mps_.size() * yaw_errors_rad_.size());
  for (std::size_t b = 0; b < beams_L.size(); ++b) {
    for (std::size_t y = 0; y < yaw_errors_rad_.size(); ++y) {
      const double yaw = yaw_errors_rad_[y];
      const std::vector<double> factors = correction.c_ti(beams_L[b], speeds_mps_, yaw);
      for (std::size_t v = 0; v < speeds_mps_.size(); ++v)
        values_[index(b, v, y)] = factors[v] * std::abs(beam_in_wind(beams_L[b], yaw).x);
    }
  }
}

bool CorrectionTable::covers(double mean_speed_mps, double yaw_error_rad) const noexcept {
  return mean_speed_mps >= speeds_mps_.front() && mean_speed_mps <= speeds_mps_.back() &&
         yaw_error_rad >= yaw_errors_rad_.front() && yaw_error_rad <= yaw_errors_rad_.back();
}

CorrectionTable::Place CorrectionTable::find(double mean_speed_mps,
                                             double yaw_error_rad) const noexcept {
  const auto [speed, speed_part] = interval(speeds_mps_, mean_speed_mps);
  const auto [yaw, yaw_part] = interval(yaw_errors_rad_, yaw_error_rad);
  return {speed, yaw, speed_part, yaw_part};
}

double CorrectionTable::at(std::size_t beam, const Place& p) const noexcept {
  const auto along_yaw = [&](std::size_t speed) {
    const double low = corner(beam, speed, p.yaw);
    return p.yaw_part == 0.0 ? low : low + p.yaw_part * (corner(beam, speed, p.yaw + 1) - low);
  };
  const double low = along_yaw(p.speed);
  return p.speed_part == 0.0 ? low : low + p.speed_part * (along_yaw(p.speed + 1) - low);
}

double CorrectionTable::corner(std::size_t beam, std::size_t speed,
                               std::size_t yaw) const noexcept {
  return values_[index(beam, speed, yaw)];
}

}  // namespace lac
