// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/kaimal.hpp"
#include "sim_harness/design/correlation_model.hpp"
#include "sim_harness/design/lidar_volumes.hpp"
#include "sim_harness/wind/kaimal_evolution.hpp"
#include "sim_harness/wind/kaimal_source.hpp"

namespace lac::sim {

struct KaimalTurbulence {
  KaimalModel model;
  ExponentialEvolution evolution = {};  // frozen
  LateralCoherence lateral = LateralCoherence::kSameAsU;
};

/// Kaimal spectra, exponential coherence across and along the wind (methods section 4; GUO eqs. 25,
/// 31, 33). Points p of all volumes, a_p = share of the volume . e^(i k1 x_p):
///
///   S_RR = S_u <gamma_yz> over pairs of points of the disk
///   S_LL = 1/n^2 sum_pq a_p^* a_q gamma_yz(r_pq) gamma_x(|d_p - d_q|) sum_c S_c n_c,p n_c,q/(n_x
///   n_x) S_RL = 1/n S_u sum_p a_p <gamma_yz>_disk(p) gamma_x(d_p)
///
/// d is the distance of the plane, not of the point: Taylor's hypothesis within a volume. With
/// kIndependent v and w of a continuous volume average out altogether; in points they remain.
/// Everything is a function of k1 alone, so cut-off frequencies are proportional to the mean wind
/// speed. Cost: pairs of points, quadratic in volumes, once for all wind speeds.
class KaimalCorrelation : public CorrelationModel {
 public:
  KaimalCorrelation(const KaimalTurbulence& turbulence, LidarVolumes lidar, double rotor_radius_m);

  std::vector<RotorLidarSpectra> at(double k1_radpm,
                                    const std::vector<double>& speeds_mps) const override;

 private:
  struct Point {
    double y_m, z_m;
    double x_m;  // from the plane
    double share;
    Vec3 weight;
  };
  struct Densities {
    double u, v, w;  // two-sided in k1 [m^3/s^2]
  };
  using Waves = std::vector<std::complex<double>>;  // share e^(i k1 x) of the points of a plane

  Densities densities(double k1_radpm) const;
  Waves waves(std::size_t plane, double k1_radpm) const;
  /// Two planes as if they were one: without the coherence along the wind.
  double pair_sum(std::size_t g, const Waves& of_g, std::size_t h, const Waves& of_h,
                  const Densities& s, double rate_per_m) const;
  /// Of a plane and the rotor disk, likewise.
  std::complex<double> rotor_sum(std::size_t plane, const Waves& waves, double rate_per_m) const;
  /// What independent v and w leave in points.
  double own_sum(std::size_t plane, const Densities& s) const;

  KaimalTurbulence turbulence_;
  LidarVolumes lidar_;
  double rotor_radius_m_;
  std::vector<std::vector<Point>> points_;  // of each plane
};

}  // namespace lac::sim
