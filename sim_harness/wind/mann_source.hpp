// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_harness/wind/mann_box.hpp"
#include "sim_harness/wind/velocity_grid.hpp"

namespace lac::sim {

struct MannFieldParams {
  MannParams model;
  double mean_speed_mps = 18.0;  // U at hub height
  double hub_height_m = 90.0;    // centre of the grid
  double shear_exponent = 0.0;   // of the mean profile U (z / z_hub)^exponent
  double width_m = 140.0;        // of what is handed out; the box is wider
  double height_m = 140.0;
  int ny = 27;
  int nz = 27;
  /// Points of the box, in which the field repeats: even, at least ny and nz. 0: the next length
  /// from 2.5 times as many that transforms are fast at. See MannBox on what the period does.
  int box_ny = 0;
  int box_nz = 0;
  double dt_s = 0.1;
  double duration_s = 660.0;  // the period: the field repeats after it
  std::uint64_t seed = 1;
  SmallEddies small_eddies = SmallEddies::kFolded;
  bool rescale = false;  // each component to the variance of the tensor
  int threads = 2;       // changes the time taken, not one bit of the field
};

/// Expected variances (and covariances) [m^2/s^2] of a generated field: of the tensor, over all
/// wavenumbers, and what the box has of them without rescaling.
struct MannVariance {
  SpectralTensor tensor;
  SpectralTensor box;
};

/// What all planes of a Mann field have in common: parameters, box, grid and scale. Harmonics m of
/// the period T in time are the wavenumbers k1 = m 2 pi / (U T).
class MannSource {
 public:
  /// Throws lac::Error on parameters out of range.
  explicit MannSource(const MannFieldParams& params);

  /// With the size of the box filled in.
  const MannFieldParams& params() const { return params_; }
  const MannBox& box() const { return box_; }
  const GridSpec& grid() const { return grid_; }
  /// Of u, at each height of the grid.
  const std::vector<float>& mean_profile_mps() const { return mean_mps_; }
  MannVariance variance() const;

  int harmonics() const { return grid_.nt / 2; }
  double k1_radpm(int m) const { return m * box_.spec().k1_min_radpm; }
  /// Factor of the amplitudes C n of a component: sqrt(dk1) and, if asked for, what rescales it.
  /// The last harmonic of an even number of steps (Nyquist) is real and stands for both signs.
  float scale(int component, int m) const;

 private:
  MannFieldParams params_;
  GridSpec grid_;
  MannBox box_;
  std::vector<float> mean_mps_;
  std::array<float, 3> scale_;
};

}  // namespace lac::sim
