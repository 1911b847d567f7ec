// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/wind/rotor_wind.hpp"

namespace lac::sim {

/// What a rotor meets in a field, as series over the samples t_begin + i dt of a RotorWind.
struct RotorSignals {
  double t_begin_s = 0.0;
  double dt_s = 0.0;
  std::size_t point_count = 0;
  std::vector<double> rews_mps;
  /// Slopes of the plane that fits u over the disk best (least squares over its points): [m/s per
  /// m] to the left and upwards. 0 where the disk has but one point.
  std::vector<double> shear_y_per_s;
  std::vector<double> shear_z_per_s;
  /// Rotor-averaged turbulence intensity TI_R [-] of the window that ends at the sample (Schlipf et
  /// al. 2020, eqs. 3-5): mean over the points of their standard deviations (with n_t - 1), over
  /// the mean of their means. NaN until the window is full.
  std::vector<double> intensity;
};

/// The points are those of RotorWind. window_s is rounded to whole samples.
/// Throws lac::Error as RotorWind, or if the window has fewer than two samples.
RotorSignals rotor_signals(const WindField& field, const RotorWindParams& params, double window_s);

}  // namespace lac::sim
