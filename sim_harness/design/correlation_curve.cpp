// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/correlation_curve.hpp"

#include <cmath>

#include "core/units.hpp"
#include "sim_harness/wind/parallel_jobs.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "correlation curves";

double sinc(double x) {
  return std::abs(x) < 1e-9 ? 1.0 : std::sin(kPi * x) / (kPi * x);
}

}  // namespace

double CorrelationCurve::frequency_hz(std::size_t i) const {
  return k1_radpm[i] * mean_speed_mps / (2.0 * kPi);
}

std::vector<double> CorrelationCurve::coherence() const {
  std::vector<double> result;
  for (std::size_t i = 0; i < k1_radpm.size(); ++i)
    result.push_back(std::norm(s_rl[i]) / (s_rr[i] * s_ll[i]));
  return result;
}

std::vector<double> CorrelationCurve::gain() const {
  std::vector<double> result;
  for (std::size_t i = 0; i < k1_radpm.size(); ++i) result.push_back(std::abs(s_rl[i]) / s_ll[i]);
  return result;
}

std::vector<double> CorrelationCurve::lateness_s() const {
  std::vector<double> result;
  for (std::size_t i = 0; i < k1_radpm.size(); ++i)
    result.push_back(std::arg(s_rl[i]) / (k1_radpm[i] * mean_speed_mps));
  return result;
}

CorrelationCurves::CorrelationCurves(const CorrelationModel& model, std::vector<double> speeds_mps,
                                     const CurveSettings& s)
    : speeds_mps_(std::move(speeds_mps)), scan_time_s_(s.scan_time_s) {
  require_positive(kWhere, "first k1 [rad/m]", s.first_k1_radpm);
  require(s.last_k1_radpm > s.first_k1_radpm, kWhere, "last k1 [rad/m]", s.last_k1_radpm,
          "more than the first one");
  require(s.points >= 2, kWhere, "points", s.points, "2 or more");
  for (const double speed : speeds_mps_) require_positive(kWhere, "mean wind speed [m/s]", speed);
  const double step = std::log(s.last_k1_radpm / s.first_k1_radpm) / (s.points - 1);
  for (int i = 0; i < s.points; ++i) k1_radpm_.push_back(s.first_k1_radpm * std::exp(i * step));
  spectra_.resize(k1_radpm_.size());
  for_each_job(s.points, s.threads, [&] {
    return [&](int job) {
      const auto i = static_cast<std::size_t>(job);
      spectra_[i] = model.at(k1_radpm_[i], speeds_mps_);
    };
  });
}

CorrelationCurve CorrelationCurves::curve(std::size_t speed, std::size_t first_plane) const {
  const double u_mps = speeds_mps_[speed], one_sided = 4.0 * kPi / u_mps;
  CorrelationCurve c{u_mps, k1_radpm_, {}, {}, {}};
  for (std::size_t i = 0; i < k1_radpm_.size(); ++i) {
    const RotorLidarSpectra& s = spectra_[i][speed];
    const double held = sinc(c.frequency_hz(i) * scan_time_s_);
    c.s_rr.push_back(one_sided * s.s_rr);
    c.s_ll.push_back(one_sided * held * held * s.s_ll[first_plane]);
    c.s_rl.push_back(one_sided * held * s.s_rl[first_plane]);
  }
  return c;
}

}  // namespace lac::sim
