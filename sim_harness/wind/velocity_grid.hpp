// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lac::sim {

/// Geometry of a y-z grid over time. y is centred on the rotor axis, y_i = (i - (ny - 1)/2) dy;
/// z_j = z_bottom + j dz; t_k = k dt.
struct GridSpec {
  int ny = 0;
  int nz = 0;
  int nt = 0;
  double dy_m = 0.0;
  double dz_m = 0.0;
  double dt_s = 0.0;
  double z_bottom_m = 0.0;
  double hub_height_m = 0.0;    // where mean_speed_mps holds; information
  double mean_speed_mps = 0.0;  // U, carries the field
  bool periodic = false;        // plane nt is plane 0 again

  double y_min_m() const { return -0.5 * (ny - 1) * dy_m; }
  double y_m(int iy) const { return y_min_m() + iy * dy_m; }
  double z_m(int iz) const { return z_bottom_m + iz * dz_m; }
  std::size_t plane_points() const { return static_cast<std::size_t>(ny) * nz; }
  bool operator==(const GridSpec&) const = default;

  /// Throws lac::Error unless ny, nz, nt >= 2, steps and speed are above 0 and z_bottom >= 0.
  void check() const;
};

/// The numbers of a gridded field while it is being filled: (u, v, w) [m/s], mean speed and
/// profile included, stored [t][z][y][3].
class VelocityGrid {
 public:
  /// All zero. Throws lac::Error as GridSpec::check().
  explicit VelocityGrid(const GridSpec& spec);

  const GridSpec& spec() const { return spec_; }
  /// One time step, [z][y][3].
  std::span<float> plane(int it) { return {values_.data() + it * plane_size_, plane_size_}; }
  std::span<const float> plane(int it) const {
    return {values_.data() + it * plane_size_, plane_size_};
  }
  float& at(int it, int iz, int iy, int component) { return plane(it)[index(iz, iy, component)]; }
  float at(int it, int iz, int iy, int component) const {
    return plane(it)[index(iz, iy, component)];
  }

 private:
  std::size_t index(int iz, int iy, int component) const {
    return (static_cast<std::size_t>(iz) * spec_.ny + iy) * 3 + component;
  }

  GridSpec spec_;
  std::size_t plane_size_ = 0;
  std::vector<float> values_;  // one number longer: interpolation loads points four at a time
};

}  // namespace lac::sim
