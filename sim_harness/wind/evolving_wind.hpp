// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/wind/gridded_wind.hpp"

namespace lac::sim {

/// The wind as it is while it is distance_m away from the rotor plane, up-wind. Its time axis is
/// that of arrival at the rotor, as in every gridded field.
struct WindPlane {
  double distance_m = 0.0;
  GriddedWind wind;
};

/// Turbulence that changes on its way to the rotor: gridded fields at some distances, each like
/// the one before but for what has decayed and grown between them.
///
/// velocity() at x is that of the plane nearest to -x, carried to x with Taylor's hypothesis over
/// arrival times: velocity(x, y, z, t) = plane(-x).velocity(x, y, z, t). At every x the one-point
/// and the yz statistics are exactly those of one plane; the longitudinal coherence is exact
/// between the planes themselves and a staircase in between. (Mixing two neighbours would be
/// smooth, and take variance out between them.) Half-way points belong to the nearer plane to the
/// rotor; down-wind of the rotor the first plane holds, up-wind of the last plane the last one.
/// Put planes at the gates of the lidar: a gate then reads its own plane, and with gates close to
/// each other the ends of its probe volume read the neighbours'.
class EvolvingWind final : public WindField {
 public:
  /// Distances rise from 0 (the rotor plane). Throws lac::Error unless they do and all planes are
  /// on one grid (GridSpec).
  explicit EvolvingWind(std::vector<WindPlane> planes);

  Vec3 velocity(const Vec3& position_I_m, double time_s) const override {
    return planes_[nearest(-position_I_m.x)].wind.velocity(position_I_m, time_s);
  }
  double mean_speed_mps() const override { return planes_.front().wind.mean_speed_mps(); }
  WindExtent extent() const override { return planes_.front().wind.extent(); }
  std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const override {
    return planes_.front().wind.disk_points(hub_height_m, radius_m);
  }

  const std::vector<WindPlane>& planes() const { return planes_; }

 private:
  std::size_t nearest(double distance_m) const {
    std::size_t plane = 0;
    while (plane < borders_m_.size() && distance_m > borders_m_[plane]) ++plane;
    return plane;
  }

  std::vector<WindPlane> planes_;
  std::vector<double> borders_m_;  // half-way between neighbours
};

}  // namespace lac::sim
