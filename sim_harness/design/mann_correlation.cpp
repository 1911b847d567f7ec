// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/mann_correlation.hpp"

#include <math.h>  // j1: the C library's is ten times as fast as std::cyl_bessel_j

#include <cmath>

#include "sim_harness/design/volume_row.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

using Complex = std::complex<double>;

constexpr auto kWhere = "correlation of lidar and rotor";

double disk_filter(double kr) {
  return kr < 1e-6 ? 1.0 : 2.0 * ::j1(kr) / kr;
}

/// What one plane contributes at one wave vector, planes counted from the farthest.
struct PlaneTerm {
  PlaneSum a;      // n A_g
  PlaneSum phi_a;  // Phi A_g
  double own;      // Re[(Phi A_g)^* . A_g]
};

PlaneTerm plane_term(const SpectralTensor& phi, const PlaneSum& a) {
  PlaneTerm t{a, {}, 0.0};
  t.phi_a[0] = phi[kUu] * a[0] + phi[kUv] * a[1] + phi[kUw] * a[2];
  t.phi_a[1] = phi[kUv] * a[0] + phi[kVv] * a[1] + phi[kVw] * a[2];
  t.phi_a[2] = phi[kUw] * a[0] + phi[kVw] * a[1] + phi[kWw] * a[2];
  for (std::size_t c = 0; c < 3; ++c)
    t.own += t.phi_a[c].real() * a[c].real() + t.phi_a[c].imag() * a[c].imag();
  return t;
}

/// Sums over wave vectors of what each plane adds to those behind it, for one wind speed.
class SpeedSums {
 public:
  SpeedSums(const LidarVolumes& lidar, double speed_mps) {
    for (auto p = lidar.planes.rbegin(); p != lidar.planes.rend(); ++p) {
      const double next_m = std::next(p) == lidar.planes.rend() ? 0.0 : std::next(p)->distance_m;
      way_s_.push_back((p->distance_m - next_m) / speed_mps);
    }
    decay_.resize(way_s_.size());
    s_ll_.resize(way_s_.size());
    s_rl_.resize(way_s_.size());
  }

  /// disk: D at this wave vector; rate: 1/tau_e [1/s].
  void add(const std::vector<PlaneTerm>& terms, double weight, double disk, double rate_per_s) {
    for (std::size_t g = 0; g < way_s_.size(); ++g)
      decay_[g] = rate_per_s == 0.0 ? 1.0 : std::exp(-way_s_[g] * rate_per_s);
    double b[6] = {};
    for (std::size_t g = 0; g < way_s_.size(); ++g) {
      const double before = g == 0 ? 0.0 : decay_[g - 1];
      double product = 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        b[2 * c] = terms[g].a[c].real() + before * b[2 * c];
        b[2 * c + 1] = terms[g].a[c].imag() + before * b[2 * c + 1];
        product += terms[g].phi_a[c].real() * b[2 * c] + terms[g].phi_a[c].imag() * b[2 * c + 1];
      }
      s_ll_[g] += weight * (2.0 * product - terms[g].own);
    }
    double to_rotor = weight * disk;
    for (std::size_t g = way_s_.size(); g-- > 0;) {
      to_rotor *= decay_[g];
      s_rl_[g] += to_rotor * terms[g].phi_a[0];
    }
  }

  /// Planes from the nearest on; lidar for the numbers of volumes.
  RotorLidarSpectra result(const LidarVolumes& lidar, double s_rr) const {
    const std::size_t planes = way_s_.size();
    RotorLidarSpectra r{s_rr, std::vector<double>(planes), std::vector<Complex>(planes)};
    double s_ll = 0.0;
    Complex s_rl = 0.0;
    for (std::size_t g = 0; g < planes; ++g) {
      const std::size_t first = planes - 1 - g;
      const double n = static_cast<double>(lidar.count(first));
      r.s_ll[first] = (s_ll += s_ll_[g]) / (n * n);
      r.s_rl[first] = (s_rl += s_rl_[g]) / n;
    }
    return r;
  }

 private:
  std::vector<double> way_s_;  // to the next nearer plane, or to the rotor; farthest first
  std::vector<double> decay_;
  std::vector<double> s_ll_;
  std::vector<Complex> s_rl_;
};

}  // namespace

MannCorrelation::MannCorrelation(const MannParams& turbulence, LidarVolumes lidar,
                                 double rotor_radius_m, const MannQuadrature& quadrature)
    : tensor_(turbulence),
      lidar_(std::move(lidar)),
      rotor_radius_m_(rotor_radius_m),
      quadrature_(quadrature),
      mirrored_(is_mirrored(lidar_)) {
  require(rotor_radius_m >= 0.0, kWhere, "rotor radius [m]", rotor_radius_m, "0 or above");
  require_positive(kWhere, "reach of the quadrature", quadrature.reach);
}

std::vector<RotorLidarSpectra> MannCorrelation::at(double k1_radpm,
                                                   const std::vector<double>& speeds_mps) const {
  const SinhNodes n(k1_radpm, tensor_.params().length_m, quadrature_.nodes, quadrature_.reach);
  const auto middle = static_cast<std::size_t>(quadrature_.nodes / 2);
  const bool evolves = std::isfinite(tensor_.params().evolution_s);
  VolumeRow volumes(lidar_, n, k1_radpm);
  std::vector<SpeedSums> sums;
  for (const double speed : speeds_mps) sums.emplace_back(lidar_, speed);
  std::vector<PlaneTerm> terms(lidar_.planes.size());
  double s_rr = 0.0;
  for (std::size_t i = mirrored_ ? middle : 0; i < n.k_radpm.size(); ++i) {
    const double both = mirrored_ && i > middle ? 2.0 : 1.0;
    for (std::size_t j = 0; j < n.k_radpm.size(); ++j) {
      const double k2 = n.k_radpm[i], k3 = n.k_radpm[j];
      const double weight = both * n.weight_radpm[i] * n.weight_radpm[j];
      const SpectralTensor phi = tensor_(k1_radpm, k2, k3);
      const double disk = disk_filter(std::hypot(k2, k3) * rotor_radius_m_);
      s_rr += weight * phi[kUu] * disk * disk;
      volumes.set_wave(i, j);
      for (std::size_t g = 0; g < terms.size(); ++g)
        terms[g] = plane_term(phi, volumes.plane_sum(g));
      const double rate =
          evolves ? 1.0 / tensor_.evolution_time_s(std::hypot(k1_radpm, k2, k3)) : 0.0;
      for (SpeedSums& s : sums) s.add(terms, weight, disk, rate);
    }
  }
  std::vector<RotorLidarSpectra> result;
  for (const SpeedSums& s : sums) result.push_back(s.result(lidar_, s_rr));
  return result;
}

}  // namespace lac::sim
