// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/rotor_signals.hpp"

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

/// Weights w_i such that sum w_i u_i is the slope of the best plane in y, and in z.
struct SlopeWeights {
  std::vector<double> y_per_m;
  std::vector<double> z_per_m;
};

SlopeWeights slope_weights(const std::vector<DiskPoint>& points) {
  const double n = static_cast<double>(points.size());
  double y_mean = 0.0, z_mean = 0.0;
  for (const DiskPoint& p : points) y_mean += p.y_m / n, z_mean += p.z_m / n;
  double yy = 0.0, zz = 0.0, yz = 0.0;
  for (const DiskPoint& p : points) {
    yy += (p.y_m - y_mean) * (p.y_m - y_mean);
    zz += (p.z_m - z_mean) * (p.z_m - z_mean);
    yz += (p.y_m - y_mean) * (p.z_m - z_mean);
  }
  SlopeWeights weights{std::vector<double>(points.size()), std::vector<double>(points.size())};
  if (points.size() == 1) return weights;
  const double determinant = yy * zz - yz * yz;
  require(determinant > 1e-12 * yy * zz, "rotor signals", "number of points in the disk", n,
          "points that are not all on one line");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double y = points[i].y_m - y_mean, z = points[i].z_m - z_mean;
    weights.y_per_m[i] = (zz * y - yz * z) / determinant;
    weights.z_per_m[i] = (yy * z - yz * y) / determinant;
  }
  return weights;
}

/// Running sums of one point; about a fixed speed, so that squares do not cancel.
struct RunningMoments {
  double sum = 0.0;
  double squares = 0.0;

  void add(double x) { sum += x, squares += x * x; }
  void drop(double x) { sum -= x, squares -= x * x; }
  double sigma(double n) const {
    return std::sqrt(std::max(squares - sum * sum / n, 0.0) / (n - 1.0));
  }
};

double intensity_of(const std::vector<RunningMoments>& moments, double n, double about_mps) {
  double sigma = 0.0, mean = 0.0;
  for (const RunningMoments& m : moments) {
    sigma += m.sigma(n);
    mean += about_mps + m.sum / n;
  }
  return sigma / mean;
}

}  // namespace

RotorSignals rotor_signals(const WindField& field, const RotorWindParams& params, double window_s) {
  const RotorWind rotor_wind(field, params);
  const auto window = static_cast<std::size_t>(std::max(window_s / params.dt_s + 0.5, 0.0));
  require(window >= 2, "rotor signals", "window [s]", window_s, "two samples or more");
  const std::vector<DiskPoint> points = field.disk_points(params.hub_height_m, params.radius_m);
  const SlopeWeights weights = slope_weights(points);

  RotorSignals s;
  s.t_begin_s = params.t_begin_s;
  s.dt_s = params.dt_s;
  s.point_count = points.size();
  s.rews_mps.assign(rotor_wind.samples_mps().begin(), rotor_wind.samples_mps().end());
  const double about_mps = s.rews_mps.front();
  std::vector<RunningMoments> moments(points.size());
  const auto u_at = [&](std::size_t i, std::size_t k) {
    const double time_s = params.t_begin_s + static_cast<double>(k) * params.dt_s;
    return field.velocity({0.0, points[i].y_m, points[i].z_m}, time_s).x - about_mps;
  };
  for (std::size_t k = 0; k < s.rews_mps.size(); ++k) {
    double slope_y = 0.0, slope_z = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double u = u_at(i, k);
      slope_y += weights.y_per_m[i] * u;
      slope_z += weights.z_per_m[i] * u;
      moments[i].add(u);
      if (k >= window) moments[i].drop(u_at(i, k - window));
    }
    s.shear_y_per_s.push_back(slope_y);
    s.shear_z_per_s.push_back(slope_z);
    s.intensity.push_back(k + 1 >= window
                              ? intensity_of(moments, static_cast<double>(window), about_mps)
                              : std::numeric_limits<double>::quiet_NaN());
  }
  return s;
}

}  // namespace lac::sim
