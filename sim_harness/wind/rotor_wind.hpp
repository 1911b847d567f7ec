// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

struct RotorWindParams {
  double radius_m = 63.0;
  double hub_height_m = 90.0;
  double t_begin_s = 0.0;  // may be negative where the field is defined there
  double t_end_s = 660.0;  // covered at least up to here
  double dt_s = 0.1;
};

/// Rotor-effective wind speed: the mean of u over the disk at x = 0 (GUO eq. 23, methods section
/// 4), as a series of samples with linear interpolation between.
///
/// The mean is over the field's own disk_points(): the grid points of a gridded field, a 5 m
/// raster about the hub otherwise, the hub alone for a uniform wind; points with r <= R count,
/// all with the same weight. Exact at the samples, and between them for a gridded field if dt_s
/// and t_begin_s fall on its steps.
class RotorWind {
 public:
  /// Throws lac::Error if the disk or the times leave the field, or no point is in the disk.
  RotorWind(const WindField& field, const RotorWindParams& params);

  /// REWS [m/s]; the first or last sample outside [t_begin, t_end].
  double at(double time_s) const noexcept {
    const double steps = (time_s - t_begin_s_) * inverse_dt_;
    const double inside = steps > 0.0 ? (steps < last_ ? steps : last_) : 0.0;
    const auto i = static_cast<std::size_t>(inside);
    return samples_mps_[i] + (inside - i) * (samples_mps_[i + 1] - samples_mps_[i]);
  }

  /// Samples at t_begin + i dt.
  std::span<const double> samples_mps() const { return {samples_mps_.data(), count_}; }
  std::size_t point_count() const { return point_count_; }

 private:
  double t_begin_s_;
  double inverse_dt_;
  std::size_t count_;
  double last_;
  std::size_t point_count_;
  std::vector<double> samples_mps_;  // the last one twice, for at(t_end)
};

}  // namespace lac::sim
