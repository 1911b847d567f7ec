// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/vec3.hpp"

namespace lac::sim {

/// Where and when a field is defined, in frame I. Fields that are the same everywhere and always
/// have no bounds. Times are those of arrival at the rotor plane, t - x / U.
struct WindExtent {
  double y_min_m = -std::numeric_limits<double>::infinity();
  double y_max_m = std::numeric_limits<double>::infinity();
  double z_min_m = -std::numeric_limits<double>::infinity();
  double z_max_m = std::numeric_limits<double>::infinity();
  double t_min_s = -std::numeric_limits<double>::infinity();
  double t_max_s = std::numeric_limits<double>::infinity();
};

/// A point of the rotor plane (x = 0), frame I.
struct DiskPoint {
  double y_m = 0.0;
  double z_m = 0.0;

  /// A point on the rim counts as inside, rounding of the grid spacing included.
  bool inside(double hub_height_m, double radius_m) const {
    return std::hypot(y_m, z_m - hub_height_m) <= radius_m * (1.0 + 1e-9);
  }
};

/// Raster that stands for the rotor disk in fields without points of their own.
inline constexpr double kDiskRaster_m = 5.0;

/// Square raster with one point on the rotor axis; every point within the radius counts.
inline std::vector<DiskPoint> disk_raster(double hub_height_m, double radius_m, double step_m) {
  std::vector<DiskPoint> points;
  const int n = static_cast<int>(radius_m / step_m) + 1;
  for (int j = -n; j <= n; ++j) {
    for (int i = -n; i <= n; ++i) {
      const DiskPoint p{i * step_m, hub_height_m + j * step_m};
      if (p.inside(hub_height_m, radius_m)) points.push_back(p);
    }
  }
  return points;
}

/// Undisturbed wind. One question: the velocity at a point and a time.
///
/// Frame I: x down-wind with the rotor plane at x = 0 (up-wind is x < 0), y to the left looking
/// down-wind with the rotor axis at y = 0, z height above ground.
/// Fields are immutable after construction: many simulations may read one at the same time.
class WindField {
 public:
  virtual ~WindField() = default;

  /// (u, v, w) [m/s] in frame I. Taylor's hypothesis carries the field down-wind with
  /// mean_speed_mps(): velocity(x, y, z, t) = velocity(0, y, z, t - x / U).
  /// Precondition: y, z and t - x / U inside extent(); callers check once, at set-up.
  virtual Vec3 velocity(const Vec3& position_I_m, double time_s) const = 0;

  virtual double mean_speed_mps() const = 0;
  virtual WindExtent extent() const { return {}; }
  /// After this time the field repeats itself; infinity where it does not.
  virtual double period_s() const { return std::numeric_limits<double>::infinity(); }
  /// False for a place inside extent() that the field has not kept (a field thinned to a
  /// WindDemand): velocity() would throw.
  virtual bool holds(const Vec3& /*position_I_m*/) const { return true; }

  /// Latest time of arrival at the rotor plane; infinity where the field never ends. A lidar at
  /// up-wind distance d needs the simulation to end at time_end_s() - d / U or before.
  double time_end_s() const { return extent().t_max_s; }

  /// The points that stand for the rotor disk when the field is averaged over it (methods
  /// section 4): a 5 m raster, unless the field has points of its own.
  virtual std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const {
    return disk_raster(hub_height_m, radius_m, kDiskRaster_m);
  }

 protected:
  WindField() = default;
  WindField(const WindField&) = default;
  WindField& operator=(const WindField&) = default;
};

}  // namespace lac::sim
