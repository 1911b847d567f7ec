// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/quadrature_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace lac::sim {
namespace {

double gain_at_cutoff(const DesignCase& d, const FeedforwardPoint& p) {
  const double k1_radpm = radps_from_hz(p.cutoff_hz) / p.mean_speed_mps;
  const RotorLidarSpectra s =
      make_correlation(d, lidar_volumes(d.lidar, d.volumes))->at(k1_radpm, {p.mean_speed_mps})[0];
  return std::abs(s.s_rl[p.first_plane]) / s.s_ll[p.first_plane];
}

}  // namespace

double quadrature_error(const DesignCase& design, const std::vector<FeedforwardPoint>& points) {
  DesignCase finer = design;
  finer.quadrature = {2 * design.quadrature.nodes - 1, 2.0 * design.quadrature.reach};
  finer.volumes.range_points = 2 * design.volumes.range_points - 1;
  const auto change = [&](const FeedforwardPoint& p) {
    return std::abs(gain_at_cutoff(design, p) / gain_at_cutoff(finer, p) - 1.0);
  };
  return std::max(change(points.front()), change(points.back()));
}

}  // namespace lac::sim
