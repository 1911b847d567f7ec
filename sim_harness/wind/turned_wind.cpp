// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/turned_wind.hpp"

#include <algorithm>

#include "core/units.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "turned wind";
constexpr double kMostAngle_rad = rad_from_deg(80.0);

void check(const FlowDirection& d) {
  require(std::abs(d.yaw_rad) < kMostAngle_rad, kWhere, "yaw [deg]", deg_from_rad(d.yaw_rad),
          "between -80 and 80");
  require(std::abs(d.upflow_rad) < kMostAngle_rad, kWhere, "upflow [deg]",
          deg_from_rad(d.upflow_rad), "between -80 and 80");
  require(std::isfinite(d.reach_m) && d.reach_m >= 0.0, kWhere, "reach_m", d.reach_m,
          "0 or a finite number above");
}

/// The part of [low, high] that is left when positions shift by up to shift and shrink by cosine;
/// unbounded stays unbounded.
void narrow(double& low, double& high, double shift, double cosine, double centre) {
  low = centre + (low - centre + shift) / cosine;
  high = centre + (high - centre - shift) / cosine;
}

double greatest(double low, double high) {
  return std::max(std::abs(low), std::abs(high));
}

/// 0 infinity is 0 here: an axis that is not touched.
double product(double factor, double length) {
  return factor == 0.0 ? 0.0 : std::abs(factor) * length;
}

void require_room(double low, double high, const char* name) {
  require(high > low, kWhere, name, high - low,
          "above 0: the field is too small to be turned that far with this reach");
}

}  // namespace

WindAxes::WindAxes(double hub_height_m, const FlowDirection& direction)
    : hub_height_m_(hub_height_m) {
  check(direction);
  const Rotation turn =
      rotation_from_roll_pitch_yaw(0.0, -direction.upflow_rad, -direction.yaw_rad);
  x_I_ = turn * Vec3{1.0, 0.0, 0.0};
  y_I_ = turn * Vec3{0.0, 1.0, 0.0};
  z_I_ = turn * Vec3{0.0, 0.0, 1.0};
}

TurnedWind::TurnedWind(std::unique_ptr<const WindField> field, double hub_height_m,
                       const FlowDirection& direction)
    : field_(std::move(field)), axes_(hub_height_m, direction) {
  set_extent(direction.reach_m);
}

void TurnedWind::set_extent(double reach_m) {
  WindExtent e = field_->extent();
  narrow(e.y_min_m, e.y_max_m, product(axes_.y_I().x, reach_m), axes_.y_I().y, 0.0);
  require_room(e.y_min_m, e.y_max_m, "width left [m]");
  const double y_m = std::isfinite(e.y_max_m) ? greatest(e.y_min_m, e.y_max_m) : reach_m;
  narrow(e.z_min_m, e.z_max_m, product(axes_.z_I().x, reach_m) + product(axes_.z_I().y, y_m),
         axes_.z_I().z, axes_.hub_height_m());
  require_room(e.z_min_m, e.z_max_m, "height left [m]");
  if (std::isfinite(e.t_min_s) || std::isfinite(e.t_max_s)) {
    const double z_m = greatest(e.z_min_m - axes_.hub_height_m(), e.z_max_m - axes_.hub_height_m());
    const double along = field_->mean_speed_mps();
    const double lag_s = reach_m * (1.0 / mean_speed_mps() - axes_.x_I().x / along) +
                         (product(axes_.x_I().y, y_m) + product(axes_.x_I().z, z_m)) / along;
    if (std::isfinite(e.t_min_s)) delay_s_ = lag_s;
    e.t_max_s -= lag_s + delay_s_;
    require_room(e.t_min_s, e.t_max_s, "time left [s]");
  }
  extent_ = e;
}

Vec3 TurnedWind::velocity(const Vec3& position_I_m, double time_s) const {
  return axes_.turned(field_->velocity(axes_.place_in_field(position_I_m), time_s + delay_s_));
}

std::vector<DiskPoint> TurnedWind::disk_points(double hub_height_m, double radius_m) const {
  std::vector<DiskPoint> points = field_->disk_points(hub_height_m, radius_m);
  return points.size() > 1 ? points : WindField::disk_points(hub_height_m, radius_m);
}

}  // namespace lac::sim
