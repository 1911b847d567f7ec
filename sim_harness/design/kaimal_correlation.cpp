// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/kaimal_correlation.hpp"

#include <cmath>

#include "core/units.hpp"
#include "sim_harness/design/disk_mean.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {

KaimalCorrelation::KaimalCorrelation(const KaimalTurbulence& turbulence, LidarVolumes lidar,
                                     double rotor_radius_m)
    : turbulence_(turbulence), lidar_(std::move(lidar)), rotor_radius_m_(rotor_radius_m) {
  require(rotor_radius_m >= 0.0, "correlation of lidar and rotor", "rotor radius [m]",
          rotor_radius_m, "0 or above");
  for (const LidarPlane& plane : lidar_.planes) {
    points_.emplace_back();
    for (const ProbeVolume& v : plane.volumes) {
      for (const RangeNode& node : v.nodes) {
        const Vec3 p = v.centre_W + node.offset_m * v.beam_W;
        points_.back().push_back({p.y, p.z, p.x, node.weight, v.weight});
      }
    }
  }
}

KaimalCorrelation::Densities KaimalCorrelation::densities(double k1_radpm) const {
  const double f_hz = k1_radpm / (2.0 * kPi), u_mps = 1.0;  // S(f) U depends on f/U alone
  const double two_sided = u_mps / (4.0 * kPi);
  const KaimalModel& m = turbulence_.model;
  return {two_sided * m.u.spectrum(f_hz, u_mps), two_sided * m.v.spectrum(f_hz, u_mps),
          two_sided * m.w.spectrum(f_hz, u_mps)};
}

KaimalCorrelation::Waves KaimalCorrelation::waves(std::size_t plane, double k1_radpm) const {
  Waves result;
  for (const Point& p : points_[plane]) result.push_back(std::polar(p.share, k1_radpm * p.x_m));
  return result;
}

double KaimalCorrelation::pair_sum(std::size_t g, const Waves& of_g, std::size_t h,
                                   const Waves& of_h, const Densities& s, double rate_per_m) const {
  const bool same = turbulence_.lateral == LateralCoherence::kSameAsU;
  const Vec3 density{s.u, same ? s.v : 0.0, same ? s.w : 0.0};
  double sum = 0.0;
  for (std::size_t i = 0; i < of_g.size(); ++i) {
    const Point& p = points_[g][i];
    const Vec3 seen{density.x * p.weight.x, density.y * p.weight.y, density.z * p.weight.z};
    for (std::size_t j = 0; j < of_h.size(); ++j) {
      const Point& q = points_[h][j];
      const double dy_m = p.y_m - q.y_m, dz_m = p.z_m - q.z_m;
      const double coherence = std::exp(-rate_per_m * std::sqrt(dy_m * dy_m + dz_m * dz_m));
      const double wave = of_g[i].real() * of_h[j].real() + of_g[i].imag() * of_h[j].imag();
      sum += wave * coherence * dot(seen, q.weight);
    }
  }
  return sum;
}

double KaimalCorrelation::own_sum(std::size_t plane, const Densities& s) const {
  const bool in_points = lidar_.model == VolumeModel::kThreePoint || lidar_.weighting.is_point();
  if (!in_points || turbulence_.lateral == LateralCoherence::kSameAsU) return 0.0;
  double sum = 0.0;
  for (const Point& p : points_[plane]) {
    sum += p.share * p.share * (s.v * p.weight.y * p.weight.y + s.w * p.weight.z * p.weight.z);
  }
  return sum;
}

std::complex<double> KaimalCorrelation::rotor_sum(std::size_t plane, const Waves& waves,
                                                  double rate_per_m) const {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const Point& p = points_[plane][i];
    sum += p.weight.x * waves[i] * disk_mean(rate_per_m, rotor_radius_m_, std::hypot(p.y_m, p.z_m));
  }
  return sum;
}

std::vector<RotorLidarSpectra> KaimalCorrelation::at(double k1_radpm,
                                                     const std::vector<double>& speeds_mps) const {
  const double f_hz = k1_radpm / (2.0 * kPi), u_mps = 1.0;
  const Densities s = densities(k1_radpm);
  const double rate_per_m = turbulence_.model.coherence_rate(f_hz, u_mps);
  const auto along = [&](double dx_m) {
    return turbulence_.evolution.root_coherence(dx_m, f_hz, u_mps);
  };
  const std::size_t planes = points_.size();
  RotorLidarSpectra r;
  r.s_rr = s.u * disk_mean_of_pairs(rate_per_m, rotor_radius_m_);
  r.s_ll.resize(planes), r.s_rl.resize(planes);
  std::vector<Waves> wave(planes);
  double s_ll = 0.0;
  std::complex<double> s_rl = 0.0;
  for (std::size_t g = planes; g-- > 0;) {  // each plane against all behind it
    wave[g] = waves(g, k1_radpm);
    s_ll += pair_sum(g, wave[g], g, wave[g], s, rate_per_m) + own_sum(g, s);
    const double distance_m = lidar_.planes[g].distance_m;
    for (std::size_t h = g + 1; h < planes; ++h) {
      s_ll += 2.0 * along(lidar_.planes[h].distance_m - distance_m) *
              pair_sum(g, wave[g], h, wave[h], s, rate_per_m);
    }
    s_rl += s.u * along(distance_m) * rotor_sum(g, wave[g], rate_per_m);
    const double n = static_cast<double>(lidar_.count(g));
    r.s_ll[g] = s_ll / (n * n);
    r.s_rl[g] = s_rl / n;
  }
  return std::vector<RotorLidarSpectra>(speeds_mps.size(), r);
}

}  // namespace lac::sim
