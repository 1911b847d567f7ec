// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/uniform_wind.hpp"

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

double speed_before(const UniformWindParams& params) {
  constexpr double kLongAgo_s = -std::numeric_limits<double>::infinity();
  return state_at(params.history, kLongAgo_s, params.shear_exponent).speed_mps;
}

}  // namespace

UniformWind::UniformWind(const UniformWindParams& params) : params_(params) {
  check(params_.history);
  advection_speed_mps_ = params_.advection_speed_mps.value_or(speed_before(params_));
  require_positive("uniform wind", "advection_speed_mps", advection_speed_mps_);
  require_positive("uniform wind", "hub_height_m", params_.hub_height_m);
  require_positive("uniform wind", "reference_length_m", params_.reference_length_m);
  require(std::isfinite(params_.shear_exponent) && params_.shear_exponent >= 0.0, "uniform wind",
          "shear_exponent", params_.shear_exponent, "0 or a finite number above");
  shear_ = shear_of(params_.history, params_.shear_exponent);
}

UniformState UniformWind::state(double arrival_s) const {
  return state_at(params_.history, arrival_s, params_.shear_exponent);
}

Vec3 UniformWind::velocity(const Vec3& position_I_m, double time_s) const {
  const UniformState s = state(time_s - position_I_m.x / advection_speed_mps_);
  double profile = 1.0;
  if (shear_.any) {
    const double above_hub_m = position_I_m.z - params_.hub_height_m;
    if (s.shear_exponent != 0.0)
      profile = std::pow(position_I_m.z / params_.hub_height_m, s.shear_exponent);
    profile += (s.shear_y * position_I_m.y * std::cos(s.direction_rad) + s.shear_z * above_hub_m) /
               params_.reference_length_m;
  }
  Vec3 wind{s.speed_mps * profile + s.gust_mps, 0.0, s.vertical_mps};
  if (s.upflow_rad != 0.0) {
    const double c = std::cos(s.upflow_rad), sine = std::sin(s.upflow_rad);
    wind = {c * wind.x - sine * wind.z, 0.0, sine * wind.x + c * wind.z};
  }
  if (s.direction_rad == 0.0) return wind;
  return {wind.x * std::cos(s.direction_rad), -wind.x * std::sin(s.direction_rad), wind.z};
}

WindExtent UniformWind::extent() const {
  WindExtent extent;
  if (shear_.power_law) extent.z_min_m = 0.0;
  return extent;
}

std::vector<DiskPoint> UniformWind::disk_points(double hub_height_m, double radius_m) const {
  if (!shear_.any) return {{0.0, hub_height_m}};
  return WindField::disk_points(hub_height_m, radius_m);
}

UniformTable tabulate(const UniformWind& wind, double begin_s, double end_s, double step_s) {
  require_positive("uniform wind table", "step_s", step_s);
  require(std::isfinite(end_s) && end_s > begin_s, "uniform wind table", "end_s", end_s,
          "a time behind begin_s");
  const auto last = std::lround((end_s - begin_s) / step_s);
  UniformTable table;
  for (long i = 0; i <= last; ++i) {
    const double time_s = begin_s + static_cast<double>(i) * step_s;
    const UniformRow row{time_s, wind.state(time_s)};
    const std::size_t n = table.rows.size();
    const bool idle =
        n >= 2 && table.rows[n - 1].state == row.state && table.rows[n - 2].state == row.state;
    if (idle) table.rows.pop_back();
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace lac::sim
