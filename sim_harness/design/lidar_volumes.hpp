// SPDX-License-Identifier: Apache-2.0
// What a lidar measures, as the correlation model sees it: probe volumes sorted into planes.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec3.hpp"
#include "sim_harness/lidar/lidar_params.hpp"

namespace lac::sim {

/// How the range weighting enters.
enum class VolumeModel {
  kContinuous,  // as it is: closed-form transform (Mann), quadrature (Kaimal)
  kThreePoint,  // 1/4, 1/2, 1/4 at -W/2, 0, W/2, as public frequency-domain codes; Gaussian alone
};

/// A share of a volume in one point of the beam.
struct RangeNode {
  double offset_m = 0.0;  // from the centre, away from the lidar
  double weight = 1.0;    // all of a volume: 1
};

/// One range gate of one beam. Frame W: x along the mean wind, z up, origin in the rotor centre;
/// it is frame I but for yaw misalignment.
struct ProbeVolume {
  Vec3 beam_W;    // unit vector, away from the lidar
  Vec3 centre_W;  // its x counts from the plane that the estimate takes it for: 0 without yaw
  Vec3 weight;    // of u, v, w in v_los / n_x, not divided by the number of volumes
  double range_m = 0.0;
  std::vector<RangeNode> nodes;
};

/// Volumes that are as far from the rotor as each other; evolution acts between planes.
struct LidarPlane {
  double distance_m = 0.0;  // up-wind of the rotor
  std::vector<ProbeVolume> volumes;
};

struct LidarVolumes {
  std::vector<LidarPlane> planes;  // nearest first
  RangeWeighting weighting;
  VolumeModel model = VolumeModel::kContinuous;

  /// Of the planes from this one on.
  std::size_t count(std::size_t first_plane) const;
  /// Fourier transform of the range weighting; real, as it is symmetric.
  double transform(double wavenumber_radpm, double range_m) const;
};

struct LidarVolumeSettings {
  VolumeModel model = VolumeModel::kContinuous;
  int range_points = 21;           // of the quadrature along a beam, kContinuous
  double yaw_error_rad = 0.0;      // wind direction minus nacelle direction, about z
  double plane_tolerance_m = 0.1;  // gates within this are one plane
};

/// The lidar on its mounting, tower at rest (a spinner at azimuth 0), in the rotor centre's frame.
/// All beams measure at once. With a yaw error beams and their places turn against the wind; the
/// delay of a gate stays what it is without, and so does the rotor disk, across the wind. Throws
/// lac::Error if a gate is not up-wind of the rotor, or if kThreePoint meets another weighting than
/// the Gaussian.
LidarVolumes lidar_volumes(const LidarParams& lidar, const LidarVolumeSettings& settings);

}  // namespace lac::sim
