// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/mounting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr double kMostTilt_deg = 45.0;
constexpr double kMostRoll_deg = 180.0;
constexpr double kSteepestSlope = 3.0;
constexpr double kMostTravel_m = 100.0;

Rotation about_y(double angle_rad) {
  return rotation_from_roll_pitch_yaw(0.0, angle_rad, 0.0);
}
Rotation about_x(double angle_rad) {
  return rotation_from_roll_pitch_yaw(angle_rad, 0.0, 0.0);
}

Vec3 read_offset(YamlReader& in) {
  if (!in.has("offset_m")) return {};
  const std::vector<double> xyz = in.numbers("offset_m");
  if (xyz.size() != 3) in.fail("offset_m", "expected three numbers: x, y, z");
  return {xyz[0], xyz[1], xyz[2]};
}

void set_angles(LidarPose& pose) {
  const auto& m = pose.R_IL.m;
  pose.roll_rad = std::atan2(m[7], m[8]);
  pose.pitch_rad = std::asin(std::clamp(-m[6], -1.0, 1.0));
  pose.yaw_rad = std::atan2(m[3], m[0]);
  if (pose.yaw_rad < 0.0) pose.yaw_rad += 2.0 * kPi;
}

}  // namespace

Mounting::Mounting(const MountingParams& params, PlatformMotion platform, double hub_height_m)
    : params_(params),
      platform_(std::move(platform)),
      hub_height_m_(hub_height_m),
      attitude_is_fixed_(platform_.is_still() && params_.tower_slope == 0.0 &&
                         params_.place == MountingPlace::kNacelle) {
  at_rest_.roll_rad = params_.roll_rad;
  at_rest_.pitch_rad = params_.tilt_rad;
  at_rest_.yaw_rad = kPi + params_.yaw_rad;
  at_rest_.R_IL =
      rotation_from_roll_pitch_yaw(at_rest_.roll_rad, at_rest_.pitch_rad, at_rest_.yaw_rad);
}

RigidFrame Mounting::rotor_frame(const TurbineState& turbine, double time_s) const {
  const double slope_per_m = params_.tower_slope / hub_height_m_;
  return platform_.frame_at(time_s).carry(
      {turbine.tower_x_m, 0.0, hub_height_m_ - platform_.reference_height_m},
      {turbine.tower_v_mps, 0.0, 0.0}, about_y(slope_per_m * turbine.tower_x_m),
      {0.0, slope_per_m * turbine.tower_v_mps, 0.0});
}

LidarPose Mounting::pose(const TurbineState& turbine, double time_s) const {
  LidarPose pose = at_rest_;
  if (attitude_is_fixed_) {
    pose.position_I_m = Vec3{turbine.tower_x_m, 0.0, hub_height_m_} + params_.offset_m;
    pose.velocity_I_mps = {turbine.tower_v_mps, 0.0, 0.0};
    return pose;
  }
  RigidFrame body = rotor_frame(turbine, time_s);
  if (turns_with_rotor()) {
    body = body.carry({}, {}, about_x(turbine.azimuth_rad), {turbine.rotor_speed_radps, 0.0, 0.0});
  }
  pose.position_I_m = body.position_I_m(params_.offset_m);
  pose.velocity_I_mps = body.velocity_at_I_mps(params_.offset_m);
  pose.R_IL = body.R_IB * at_rest_.R_IL;
  set_angles(pose);
  return pose;
}

LidarPose Mounting::rest_pose(double azimuth_rad) const {
  LidarPose pose = at_rest_;
  const Rotation turned = about_x(turns_with_rotor() ? azimuth_rad : 0.0);
  pose.position_I_m = Vec3{0.0, 0.0, hub_height_m_} + turned * params_.offset_m;
  pose.R_IL = turned * at_rest_.R_IL;
  set_angles(pose);
  return pose;
}

std::vector<double> Mounting::tower_positions_m() const {
  const double side_m = std::max(params_.tower_travel_m - kTowerReach_m, 0.0);
  const int steps = static_cast<int>(std::ceil(side_m / (2.0 * kTowerReach_m)));
  std::vector<double> all{0.0};
  for (int i = 1; i <= steps; ++i) {
    all.push_back(side_m * i / steps);
    all.push_back(-all.back());
  }
  return all;
}

double Mounting::greatest_travel_m(double reach_m) const {
  const double from_hub_m = norm(params_.offset_m) + reach_m;
  const double tower_m = std::min(params_.tower_travel_m, kTowerReach_m) *
                         (1.0 + params_.tower_slope / hub_height_m_ * from_hub_m);
  const double arm_m =
      std::abs(hub_height_m_ - platform_.reference_height_m) + from_hub_m + params_.tower_travel_m;
  return tower_m + (platform_.is_still() ? 0.0 : platform_.greatest_travel_m(arm_m));
}

MountingParams read_mounting(YamlReader& in) {
  MountingParams p;
  p.place = static_cast<MountingPlace>(in.choice("mounted_on", 0, {"nacelle", "spinner"}));
  p.offset_m = read_offset(in);
  const auto angle = [&](const char* key, double most_deg) {
    return rad_from_deg(in.number(key, 0.0, Range::between(-most_deg, most_deg)));
  };
  p.tilt_rad = angle("tilt_deg", kMostTilt_deg);
  p.roll_rad = angle("roll_deg", kMostRoll_deg);
  p.yaw_rad = angle("yaw_deg", kMostTilt_deg);
  p.tower_slope = in.number("tower_slope", 0.0, Range::between(0.0, kSteepestSlope));
  p.tower_travel_m =
      in.number("tower_travel_m", p.tower_travel_m, Range::between(0.0, kMostTravel_m));
  return p;
}

}  // namespace lac::sim
