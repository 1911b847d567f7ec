// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/units.hpp"
#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/lidar/platform_motion.hpp"
#include "sim_harness/lidar/turbine_state.hpp"

namespace lac::sim {

/// Positions of the tower top for which a lidar demands wind lie so close that none between them is
/// farther than this from one.
inline constexpr double kTowerReach_m = 3.0;

enum class MountingPlace { kNacelle, kSpinner };

/// Where a lidar sits and how it is turned against the direction up-wind.
struct MountingParams {
  MountingPlace place = MountingPlace::kNacelle;
  Vec3 offset_m;          // from the rotor centre, x down-wind; on a spinner: at azimuth 0
  double tilt_rad = 0.0;  // of the viewing axis, positive looks down
  double roll_rad = 0.0;  // about the viewing axis
  double yaw_rad = 0.0;   // of the viewing axis, positive to its left
  /// Rotation of the tower top: this times x / hub height, the up-wind side up for x > 0. 0: it
  /// stays upright; 1.5: a uniform cantilever with a force at its top; 2: a parabola.
  double tower_slope = 0.0;
  /// How far the tower top may move either way: as far a thinned wind field is kept.
  double tower_travel_m = 10.0;
};

/// What a perfect inertial unit in the lidar says.
struct LidarPose {
  Vec3 position_I_m;
  Vec3 velocity_I_mps;
  Rotation R_IL;
  double roll_rad = 0.0;  // of R_IL, z-y'-x''; the yaw in 0 ... 2 pi
  double pitch_rad = 0.0;
  double yaw_rad = kPi;
};

/// The chain platform, tower top, nacelle or spinner, lidar; positions and velocities are those
/// of rigid bodies, exactly. The tower top of the model lies in the rotor centre (hub height, x = 0
/// at rest), moves along the x axis of the platform and turns, if it does, about that point.
class Mounting {
 public:
  Mounting(const MountingParams& params, PlatformMotion platform, double hub_height_m);

  /// time_s counts for the platform; all else is as the turbine says.
  LidarPose pose(const TurbineState& turbine, double time_s) const;
  /// Tower and platform at rest; the azimuth matters on a spinner only.
  LidarPose rest_pose(double azimuth_rad = 0.0) const;
  /// Frame N with its origin in the rotor centre.
  RigidFrame rotor_frame(const TurbineState& turbine, double time_s) const;
  Vec3 rotor_centre_I_m(const TurbineState& turbine, double time_s) const {
    return rotor_frame(turbine, time_s).origin_I_m;
  }
  bool turns_with_rotor() const { return params_.place == MountingPlace::kSpinner; }
  const PlatformMotion& platform() const { return platform_; }
  double hub_height_m() const { return hub_height_m_; }

  /// Positions of the tower top, 0 first, that come within kTowerReach_m of all up to
  /// tower_travel_m either way.
  std::vector<double> tower_positions_m() const;
  /// Bound on the way by which the platform, and the tower top from the nearest of these positions,
  /// take a point that is reach_m from the lidar; without what a spinner turns.
  double greatest_travel_m(double reach_m) const;

 private:
  MountingParams params_;
  PlatformMotion platform_;
  double hub_height_m_;
  bool attitude_is_fixed_;
  LidarPose at_rest_;
};

/// Keys mounted_on (nacelle, spinner), offset_m, tilt_deg, roll_deg, yaw_deg, tower_slope,
/// tower_travel_m, all with defaults. Throws lac::Error.
MountingParams read_mounting(YamlReader& in);

}  // namespace lac::sim
