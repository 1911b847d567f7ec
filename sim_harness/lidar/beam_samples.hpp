// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec3.hpp"
#include "sim_harness/lidar/lidar_params.hpp"

namespace lac::sim {

/// One gate: which of the beam's points it sees, and how much of each.
struct GateSamples {
  double range_m = 0.0;
  std::size_t first_point = 0;
  std::vector<double> weights;  // sum 1
};

/// One beam as it is sampled: points along it, and the gates made of them.
///
/// Gaussian and pulse: the points of all gates lie on one grid, so that neighbouring gates share
/// them. Lorentzian: each gate has nodes of its own, s_j = z_R sinh(t_j) with t_j equally spaced,
/// dense in the focus and thin in the tails; cut at 10 z_R, 21 nodes give its transform within
/// 0.005 for |k| z_R <= 1 and 0.02 for |k| z_R <= 2.
struct BeamSamples {
  Vec3 dir_L;
  std::vector<double> points_m;  // ranges at which the wind is taken
  std::vector<GateSamples> gates;

  double nearest_m() const;
  double farthest_m() const;
};

BeamSamples make_beam_samples(const LidarParams& lidar, const LidarBeam& beam);
/// Of all beams. Throws lac::Error for one without gates or with more than the lidar block of the
/// swap array carries.
std::vector<BeamSamples> make_beam_samples(const LidarParams& lidar);

}  // namespace lac::sim
