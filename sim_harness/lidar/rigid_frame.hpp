// SPDX-License-Identifier: Apache-2.0
// A body that moves: where a point of it is in frame I, and how fast.
#pragma once

#include "core/vec3.hpp"

namespace lac::sim {

constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// (a * b) * v = a * (b * v).
constexpr Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation product;
  for (std::size_t column = 0; column < 3; ++column) {
    const Vec3 image = a * Vec3{b.m[column], b.m[3 + column], b.m[6 + column]};
    product.m[column] = image.x;
    product.m[3 + column] = image.y;
    product.m[6 + column] = image.z;
  }
  return product;
}

/// A frame B fixed to a body.
struct RigidFrame {
  Vec3 origin_I_m;
  Vec3 velocity_I_mps;  // of the origin
  Rotation R_IB;
  Vec3 turn_rate_I_radps;  // of the body

  Vec3 position_I_m(const Vec3& point_B_m) const { return origin_I_m + R_IB * point_B_m; }
  /// Of a point that moves with velocity_B_mps within the body: v + omega x r + R v_B.
  Vec3 velocity_at_I_mps(const Vec3& point_B_m, const Vec3& velocity_B_mps = {}) const {
    return velocity_I_mps + cross(turn_rate_I_radps, R_IB * point_B_m) + R_IB * velocity_B_mps;
  }
  /// A frame C at a point of this body, turned against it by R_BC, with a rate of its own.
  RigidFrame carry(const Vec3& point_B_m, const Vec3& velocity_B_mps, const Rotation& R_BC,
                   const Vec3& turn_rate_B_radps) const {
    return {position_I_m(point_B_m), velocity_at_I_mps(point_B_m, velocity_B_mps), R_IB * R_BC,
            turn_rate_I_radps + R_IB * turn_rate_B_radps};
  }
};

}  // namespace lac::sim
