// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/lidar_on_board.hpp"

namespace lac::sim {
namespace {

LidarWeaknessSetting weakness_setting(const Case& c, const LidarPose& rest) {
  const LidarParams& lidar = c.lidar->params;
  return {.seed = c.seed,
          .number_of_blades = c.turbine.number_of_blades,
          .rotor_radius_m = c.turbine.rotor.radius_m,
          .beams = static_cast<int>(lidar.scan.beams.size()),
          .interval_s = lidar.scan.interval_s(),
          .weighting = lidar.weighting,
          .position_N_m = lidar.mounting.offset_m,
          .R_NL = rest.R_IL,
          .turns_with_rotor = lidar.mounting.place == MountingPlace::kSpinner};
}

}  // namespace

LidarOnBoard::LidarOnBoard(const Case& c, const WindField& wind) : step_s_(c.time.step_s) {
  if (!c.lidar) return;
  const LidarWeaknessParams& weak = c.lidar->weaknesses;
  if (weak.induction.model != InductionModel::kNone) {
    induced_wind_.emplace(wind, weak.induction, c.turbine.rotor.radius_m);
  }
  const WindField& seen = induced_wind_ ? static_cast<const WindField&>(*induced_wind_) : wind;
  lidar_.emplace(c.lidar->params, seen,
                 LidarSetting{c.turbine.hub_height_m, c.time.step_s, c.time.duration_s});
  weaknesses_.emplace(weak, weakness_setting(c, lidar_->mounting().rest_pose()));
  fault_.emplace(c.lidar->fault, static_cast<int>(c.lidar->params.scan.beams.size()), c.seed);
}

bool LidarOnBoard::measure(std::int64_t step, const TurbineState& turbine) {
  if (!lidar_) return false;
  const double time_s = static_cast<double>(step) * step_s_;
  if (induced_wind_) {
    const Vec3 rotor_centre_I_m = lidar_->mounting().rotor_centre_I_m(turbine, time_s);
    induced_wind_->follow(turbine.thrust_coefficient, rotor_centre_I_m, step_s_);
  }
  bool is_new = lidar_->step(step, turbine, measurement_);
  is_new = weaknesses_->pass(time_s, turbine, measurement_, is_new);
  return fault_->apply(time_s, measurement_, is_new);
}

void LidarOnBoard::sense(std::int64_t step, const TurbineState& turbine, ControllerHost& host) {
  if (!lidar_) return;
  const bool is_new = measure(step, turbine);
  host.set_lidar(measurement_, is_new);
}

}  // namespace lac::sim
