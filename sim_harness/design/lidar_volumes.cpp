// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/lidar_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "sim_harness/lidar/beam_samples.hpp"
#include "sim_harness/lidar/rigid_frame.hpp"

namespace lac::sim {
namespace {

std::vector<RangeNode> three_points(double fwhm_m) {
  return {{-0.5 * fwhm_m, 0.25}, {0.0, 0.5}, {0.5 * fwhm_m, 0.25}};
}

/// Gaussian and pulse: up to a factor.
double density(const RangeWeighting& w, double s_m) {
  const double scale_m = std::sqrt(2.0) * w.sigma_m(), half_m = 0.5 * w.gate_length_m;
  if (w.kind == ProbeKind::kGaussian) return std::exp(-s_m * s_m / (scale_m * scale_m));
  return std::erf((s_m + half_m) / scale_m) - std::erf((s_m - half_m) / scale_m);
}

/// Trapezoidal rule, to four standard deviations, where 6e-5 are left out.
std::vector<RangeNode> equal_steps(const RangeWeighting& weighting, int count) {
  const double reach_m = 4.0 / 3.0 * weighting.reach_m();
  std::vector<RangeNode> nodes;
  double sum = 0.0;
  for (int j = 0; j < count; ++j) {
    const double offset_m = reach_m * (2.0 * j / (count - 1) - 1.0);
    nodes.push_back({offset_m, density(weighting, offset_m)});
    sum += nodes.back().weight;
  }
  for (RangeNode& n : nodes) n.weight /= sum;
  return nodes;
}

/// As the simulated lidar samples.
std::vector<RangeNode> samples(const BeamSamples& beam, const GateSamples& gate) {
  std::vector<RangeNode> nodes;
  for (std::size_t j = 0; j < gate.weights.size(); ++j)
    nodes.push_back({beam.points_m[gate.first_point + j] - gate.range_m, gate.weights[j]});
  return nodes;
}

std::vector<RangeNode> range_nodes(const RangeWeighting& weighting, const LidarVolumeSettings& s,
                                   const BeamSamples& beam, const GateSamples& gate) {
  if (weighting.is_point()) return {RangeNode{}};
  if (s.model == VolumeModel::kThreePoint) return three_points(weighting.fwhm_m);
  if (weighting.kind == ProbeKind::kLorentzian) return samples(beam, gate);
  return equal_steps(weighting, s.range_points);
}

struct PlacedVolume {
  double distance_m;
  ProbeVolume volume;
};

/// The beam turns about the rotor centre with the nacelle: R_WI takes frame I to frame W.
PlacedVolume place(const Vec3& origin_I_m, const Vec3& beam_I, double range_m,
                   const Rotation& R_WI) {
  const Vec3 centre_I_m = origin_I_m + range_m * beam_I;
  ProbeVolume v{R_WI * beam_I, R_WI * centre_I_m, {}, range_m, {}};
  v.centre_W.x -= centre_I_m.x;
  v.weight = (1.0 / beam_I.x) * v.beam_W;
  return {-centre_I_m.x, v};
}

std::vector<PlacedVolume> place_all(const LidarParams& lidar, const LidarVolumeSettings& s) {
  const Mounting mounting(lidar.mounting, PlatformMotion{}, 0.0);
  const LidarPose pose = mounting.rest_pose();
  const Rotation R_WI = rotation_from_roll_pitch_yaw(0.0, 0.0, -s.yaw_error_rad);
  LidarParams sampled = lidar;
  sampled.weighting.points = s.range_points;
  std::vector<PlacedVolume> all;
  for (const BeamSamples& beam : make_beam_samples(sampled)) {
    for (const GateSamples& gate : beam.gates) {
      PlacedVolume p = place(pose.position_I_m, pose.R_IL * beam.dir_L, gate.range_m, R_WI);
      p.volume.nodes = range_nodes(lidar.weighting, s, beam, gate);
      all.push_back(std::move(p));
    }
  }
  return all;
}

}  // namespace

std::size_t LidarVolumes::count(std::size_t first_plane) const {
  std::size_t n = 0;
  for (std::size_t p = first_plane; p < planes.size(); ++p) n += planes[p].volumes.size();
  return n;
}

double LidarVolumes::transform(double wavenumber_radpm, double range_m) const {
  const double k = wavenumber_radpm;
  if (weighting.is_point()) return 1.0;
  if (model == VolumeModel::kThreePoint) return 0.5 + 0.5 * std::cos(0.5 * k * weighting.fwhm_m);
  if (weighting.kind == ProbeKind::kLorentzian)
    return std::exp(-std::abs(k) * weighting.rayleigh_m(range_m));
  const double ks = k * weighting.sigma_m(), pulse = std::exp(-0.5 * ks * ks);
  const double half_gate = 0.5 * k * weighting.gate_length_m;
  if (weighting.kind == ProbeKind::kGaussian || half_gate == 0.0) return pulse;
  return pulse * std::sin(half_gate) / half_gate;
}

LidarVolumes lidar_volumes(const LidarParams& lidar, const LidarVolumeSettings& settings) {
  if (settings.model == VolumeModel::kThreePoint && lidar.weighting.kind != ProbeKind::kGaussian)
    throw Error("lidar: three points can stand for a Gaussian range weighting only");
  LidarVolumes result{{}, lidar.weighting, settings.model};
  std::vector<PlacedVolume> all = place_all(lidar, settings);
  std::ranges::sort(all, {}, &PlacedVolume::distance_m);
  for (PlacedVolume& p : all) {
    if (!(p.distance_m > 0.0)) {
      throw Error("lidar: a gate lies " + shortest(-p.distance_m) +
                  " m behind the rotor plane, expected all of them up-wind");
    }
    auto& planes = result.planes;
    if (planes.empty() || p.distance_m > planes.back().distance_m + settings.plane_tolerance_m)
      planes.push_back({p.distance_m, {}});
    planes.back().volumes.push_back(std::move(p.volume));
  }
  return result;
}

}  // namespace lac::sim
