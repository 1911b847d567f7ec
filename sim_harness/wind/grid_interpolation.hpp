// SPDX-License-Identifier: Apache-2.0
// Interpolation in fields on a y-z grid over time, however their numbers are kept: bilinear in y
// and z, linear in t, in single precision; x by Taylor's hypothesis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/vec3.hpp"
#include "sim_harness/wind/velocity_grid.hpp"

namespace lac::sim {

/// Between point `index` of an axis and the next one.
struct GridCell {
  int index;
  float weight;  // of the next point
};

/// A position in steps within [0, n - 1]; outside (and not a number) goes to the border.
inline GridCell cell_in(double steps, int n) {
  const double last = n - 1;
  const double inside = steps > 0.0 ? (steps < last ? steps : last) : 0.0;
  const int index = std::min(static_cast<int>(inside), n - 2);
  return {index, static_cast<float>(inside - index)};
}

/// The same on a circle of n steps; what is no time goes to the first.
inline GridCell cell_on_circle(double steps, int n, double inverse_n) {
  constexpr double kMostTurns = 1e15;  // beyond, the part of a turn is rounding
  const double turns = steps * inverse_n;
  if (!(std::abs(turns) < kMostTurns)) return {0, 0.0F};
  const auto whole = static_cast<double>(static_cast<std::int64_t>(turns));
  const double turn = steps - n * (turns < whole ? whole - 1.0 : whole);
  const double inside = turn > 0.0 ? turn : 0.0;
  const int index = inside < n ? static_cast<int>(inside) : n - 1;
  return {index, static_cast<float>(inside - index)};
}

/// The eight points about a place and a time.
struct GridStencil {
  GridCell y, z, t;
  int next_t;  // on a circle not t.index + 1 always
};

class GridLocator {
 public:
  explicit GridLocator(const GridSpec& spec)
      : spec_(spec),
        y_min_m_(spec.y_min_m()),
        inverse_dy_(1.0 / spec.dy_m),
        inverse_dz_(1.0 / spec.dz_m),
        inverse_dt_(1.0 / spec.dt_s),
        inverse_nt_(1.0 / spec.nt),
        inverse_speed_(1.0 / spec.mean_speed_mps) {}

  GridCell y(double y_m) const { return cell_in((y_m - y_min_m_) * inverse_dy_, spec_.ny); }
  GridCell z(double z_m) const { return cell_in((z_m - spec_.z_bottom_m) * inverse_dz_, spec_.nz); }
  GridStencil at(const Vec3& position_I_m, double time_s) const {
    const double steps = (time_s - position_I_m.x * inverse_speed_) * inverse_dt_;
    const GridCell t =
        spec_.periodic ? cell_on_circle(steps, spec_.nt, inverse_nt_) : cell_in(steps, spec_.nt);
    return {y(position_I_m.y), z(position_I_m.z), t, t.index + 1 == spec_.nt ? 0 : t.index + 1};
  }

 private:
  GridSpec spec_;
  double y_min_m_;
  double inverse_dy_;
  double inverse_dz_;
  double inverse_dt_;
  double inverse_nt_;
  double inverse_speed_;
};

/// u, v, w and a number that is not used, in one register.
using GridPoint [[gnu::vector_size(16)]] = float;

/// uvw: u, v, w and one number more that may be read.
inline GridPoint load_point(const float* uvw) {
  GridPoint point;
  std::memcpy(&point, uvw, sizeof point);
  return point;
}

inline GridPoint mix(GridPoint a, GridPoint b, float weight_of_b) {
  return a + weight_of_b * (b - a);
}

/// Where the numbers of the four neighbours in y and z stand at one time, [2 z + y].
using GridCorners = std::array<const float*, 4>;

inline GridPoint bilinear(const GridStencil& s, const GridCorners& c) {
  return mix(mix(load_point(c[0]), load_point(c[1]), s.y.weight),
             mix(load_point(c[2]), load_point(c[3]), s.y.weight), s.z.weight);
}

/// Corners at the time steps s.t.index and s.next_t.
inline Vec3 interpolate(const GridStencil& s, const GridCorners& now, const GridCorners& next) {
  const GridPoint wind = mix(bilinear(s, now), bilinear(s, next), s.t.weight);
  return {wind[0], wind[1], wind[2]};
}

}  // namespace lac::sim
