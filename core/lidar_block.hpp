// SPDX-License-Identifier: Apache-2.0
// One lidar measurement (one beam, all its gates) and its two forms in the swap array.
#pragma once

#include <array>

#include "core/swap_view.hpp"
#include "core/units.hpp"
#include "core/vec3.hpp"

namespace lac {

enum class LidarLayout { Native, Guo, OpenFast };

struct LidarGate {
  double range_m = 0.0;    // from the lidar along the beam
  double speed_mps = 0.0;  // line-of-sight, positive towards the lidar
  bool valid = false;
  double cnr_db = 0.0;
};

/// One beam at one time. Frames: L lidar, I inertial with the origin on the ground below the
/// rotor centre (x down-wind, z up).
struct LidarMeasurement {
  double time_s = 0.0;
  int beam_id = 0;  // from 0
  Vec3 beam_dir_L{1.0, 0.0, 0.0};
  Vec3 position_I_m;
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = kPi;
  Vec3 velocity_I_mps;
  int gate_count = 0;
  std::array<LidarGate, native_lidar::kMaxGates> gates;

  Vec3 beam_dir_I() const {
    return rotation_from_roll_pitch_yaw(roll_rad, pitch_rad, yaw_rad) * beam_dir_L;
  }
};

/// Beam direction in frame L from azimuth (about z, positive to the left) and elevation.
inline Vec3 beam_direction(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad),
          std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

/// Fills our block; new_data false clears the flag and leaves the rest. Precondition: the array
/// holds kNativeLidarBlock.
void write_native_lidar(SwapView swap, const LidarMeasurement& m, bool new_data);

/// Reads our block whatever its flag. Values are taken as they stand; only the gate count is
/// held to what the block can carry. Precondition: the array holds kNativeLidarBlock.
void read_native_lidar(const SwapReader& swap, LidarMeasurement& m);
bool native_lidar_present(const SwapReader& swap);
bool native_lidar_is_new(const SwapReader& swap);

/// Where Guo's block begins (record 63) and how many gates it carries; first = 0 if record 63 or
/// the gate count makes no sense. The caller has configured this layout, so records behind 164
/// are known to be there.
struct GuoBlock {
  int first = 0;
  int gates = 0;
};
GuoBlock find_guo_block(const float* swap);

/// Beam id, speeds, attitude and velocity; range, direction, position and time are not in it.
void read_guo_lidar(const float* swap, GuoBlock block, LidarMeasurement& m);
bool guo_lidar_is_new(const float* swap, GuoBlock block);

/// Head of OpenFAST's block. A record that holds no number of this kind gives -1.
struct OpenFastHeader {
  int sensor_type = 0;  // 0 none, 1 single point, 2 continuous wave, 3 pulsed
  int beams = 0;
  int gates = 0;
  bool operator==(const OpenFastHeader&) const = default;
  /// Beams or gates, of which one is 1; 0 if they make no sense.
  int points() const {
    const int most = beams > gates ? beams : gates, least = beams + gates - most;
    return least == 1 && most <= openfast_lidar::kMaxPoints ? most : 0;
  }
};
/// Precondition of these: the array holds kOpenFastLidarBlock; point in 0..points-1.
OpenFastHeader read_openfast_header(const SwapReader& swap);
double openfast_speed(const SwapReader& swap, int point);          // as received [m/s]
double openfast_x(const SwapReader& swap, int point, int points);  // as received, global frame [m]

}  // namespace lac
