// SPDX-License-Identifier: Apache-2.0
// Three components and rotations between the frames of docs/frames_and_units.md:
// I inertial (x down-wind, z up), N nacelle, L lidar (x along the viewing axis, z up).
#pragma once

#include <array>
#include <cmath>

namespace lac {

struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  constexpr bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator*(double s, const Vec3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double norm(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

/// Rotation matrix, row-major; R_AB * v_B = v_A.
struct Rotation {
  std::array<double, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};

  constexpr Vec3 operator*(const Vec3& v) const {
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
            m[6] * v.x + m[7] * v.y + m[8] * v.z};
  }
};

/// R_IL = Rz(yaw) Ry(pitch) Rx(roll), z-y'-x'' (methods section 0). Positive pitch turns x
/// towards -z (nose down). A lidar looking up-wind has a yaw of pi.
inline Rotation rotation_from_roll_pitch_yaw(double roll_rad, double pitch_rad, double yaw_rad) {
  const double cr = std::cos(roll_rad), sr = std::sin(roll_rad);
  const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad);
  const double cy = std::cos(yaw_rad), sy = std::sin(yaw_rad);
  return {{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
           sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,  //
           -sp, cp * sr, cp * cr}};
}

}  // namespace lac
