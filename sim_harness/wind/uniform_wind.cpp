// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/uniform_wind.hpp"

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

/// Shear acts on the first part only.
struct SpeedParts {
  double sheared_mps;
  double plain_mps;
};

SpeedParts speed_at(const SteadySpeed& steady, double) {
  return {steady.speed_mps, 0.0};
}

SpeedParts speed_at(const StepSpeed& step, double time_s) {
  const double since_s = time_s - step.time_s;
  if (since_s < 0.0) return {step.from_mps, 0.0};
  if (since_s >= step.ramp_s) return {step.to_mps, 0.0};
  return {step.from_mps + (step.to_mps - step.from_mps) * since_s / step.ramp_s, 0.0};
}

SpeedParts speed_at(const GustSpeed& gust, double time_s) {
  return {gust.mean_speed_mps, eog_deviation_mps(gust.magnitude_mps, time_s - gust.start_s)};
}

double initial_speed(const SpeedHistory& history) {
  return std::visit(
      [](const auto& speed) {
        return speed_at(speed, -std::numeric_limits<double>::infinity()).sheared_mps;
      },
      history);
}

void check(const SteadySpeed& steady) {
  require_positive("steady wind", "speed_mps", steady.speed_mps);
}

void check(const StepSpeed& step) {
  require_positive("wind step", "from_mps", step.from_mps);
  require_positive("wind step", "to_mps", step.to_mps);
  require(std::isfinite(step.time_s), "wind step", "time_s", step.time_s, "a finite number");
  require(std::isfinite(step.ramp_s) && step.ramp_s >= 0.0, "wind step", "ramp_s", step.ramp_s,
          "0 or a finite number above");
}

void check(const GustSpeed& gust) {
  require_positive("operating gust", "mean_speed_mps", gust.mean_speed_mps);
  require(std::isfinite(gust.magnitude_mps) && gust.magnitude_mps >= 0.0, "operating gust",
          "magnitude_mps", gust.magnitude_mps,
          "0 or a finite number above (IEC's is below 0 once the mean exceeds V_e1)");
  require(std::isfinite(gust.start_s), "operating gust", "start_s", gust.start_s,
          "a finite number");
}

}  // namespace

UniformWind::UniformWind(const UniformWindParams& params)
    : params_(params),
      advection_speed_mps_(params.advection_speed_mps.value_or(initial_speed(params.speed))) {
  std::visit([](const auto& speed) { check(speed); }, params_.speed);
  require_positive("uniform wind", "advection_speed_mps", advection_speed_mps_);
  require_positive("uniform wind", "hub_height_m", params_.hub_height_m);
  require(std::isfinite(params_.shear_exponent) && params_.shear_exponent >= 0.0, "uniform wind",
          "shear_exponent", params_.shear_exponent, "0 or a finite number above");
}

Vec3 UniformWind::velocity(const Vec3& position_I_m, double time_s) const {
  const double arrival_s = time_s - position_I_m.x / advection_speed_mps_;
  const SpeedParts speed =
      std::visit([=](const auto& s) { return speed_at(s, arrival_s); }, params_.speed);
  const double profile =
      params_.shear_exponent == 0.0
          ? 1.0
          : std::pow(position_I_m.z / params_.hub_height_m, params_.shear_exponent);
  return {speed.sheared_mps * profile + speed.plain_mps, 0.0, 0.0};
}

WindExtent UniformWind::extent() const {
  WindExtent extent;
  if (params_.shear_exponent != 0.0) extent.z_min_m = 0.0;
  return extent;
}

std::vector<DiskPoint> UniformWind::disk_points(double hub_height_m, double radius_m) const {
  if (params_.shear_exponent == 0.0) return {{0.0, hub_height_m}};
  return WindField::disk_points(hub_height_m, radius_m);
}

}  // namespace lac::sim
