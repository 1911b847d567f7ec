// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/rotor_wind.hpp"

#include <sstream>

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "rotor wind";

void check(const RotorWindParams& p) {
  require_positive(kWhere, "radius_m", p.radius_m);
  require_positive(kWhere, "hub_height_m", p.hub_height_m);
  require_positive(kWhere, "dt_s", p.dt_s);
  require(std::isfinite(p.t_begin_s), kWhere, "t_begin_s", p.t_begin_s, "a finite number");
  require(std::isfinite(p.t_end_s) && p.t_end_s >= p.t_begin_s, kWhere, "t_end_s", p.t_end_s,
          "a finite number, t_begin_s or above");
}

void require_at_least(double found, double limit, double slack, const char* name) {
  if (found >= limit - slack) return;
  std::ostringstream expected;
  expected << "at least " << limit << ", where the wind field begins: it is too small";
  require(false, kWhere, name, found, expected.str());
}

void require_at_most(double found, double limit, double slack, const char* name) {
  if (found <= limit + slack) return;
  std::ostringstream expected;
  expected << "at most " << limit << ", where the wind field ends: it is too small";
  require(false, kWhere, name, found, expected.str());
}

void check_inside(const WindExtent& extent, const RotorWindParams& p, double last_sample_s) {
  const double slack_m = 1e-6 * p.radius_m, slack_s = 1e-6 * p.dt_s;
  require_at_least(-p.radius_m, extent.y_min_m, slack_m, "right edge of the rotor [m]");
  require_at_most(p.radius_m, extent.y_max_m, slack_m, "left edge of the rotor [m]");
  require_at_least(p.hub_height_m - p.radius_m, extent.z_min_m, slack_m,
                   "lowest height of the rotor [m]");
  require_at_most(p.hub_height_m + p.radius_m, extent.z_max_m, slack_m,
                  "greatest height of the rotor [m]");
  require_at_least(p.t_begin_s, extent.t_min_s, slack_s, "t_begin_s");
  require_at_most(last_sample_s, extent.t_max_s, slack_s, "time of the last sample [s]");
}

double disk_mean(const WindField& field, std::span<const DiskPoint> points, double time_s) {
  double sum = 0.0;
  for (const DiskPoint& p : points) sum += field.velocity({0.0, p.y_m, p.z_m}, time_s).x;
  return sum / points.size();
}

}  // namespace

RotorWind::RotorWind(const WindField& field, const RotorWindParams& params)
    : t_begin_s_(params.t_begin_s), inverse_dt_(1.0 / params.dt_s) {
  check(params);
  last_ = std::ceil((params.t_end_s - params.t_begin_s) / params.dt_s - 1e-6);
  check_inside(field.extent(), params, params.t_begin_s + last_ * params.dt_s);
  const std::vector<DiskPoint> points = field.disk_points(params.hub_height_m, params.radius_m);
  point_count_ = points.size();
  require(point_count_ > 0, kWhere, "number of points in the disk", 0,
          "at least 1 (the grid is too coarse for this rotor)");
  count_ = static_cast<std::size_t>(last_) + 1;
  samples_mps_.reserve(count_ + 1);
  for (std::size_t i = 0; i < count_; ++i)
    samples_mps_.push_back(disk_mean(field, points, params.t_begin_s + i * params.dt_s));
  samples_mps_.push_back(samples_mps_.back());
}

}  // namespace lac::sim
