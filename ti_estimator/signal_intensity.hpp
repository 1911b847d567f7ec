// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lookup_table.hpp"
#include "ti_estimator/intensity_estimate.hpp"
#include "ti_estimator/speed_statistics.hpp"

namespace lac {

struct SignalIntensityParams {
  bool used = false;
  StatisticsSpec statistics;     // of one beam and one gate; scan_time_s: between two samples
  double speed_factor = 1.0;     // free wind over mean of the signal
  double added_intensity = 0.0;  // of the signal, without a share in that of the free wind [-]
  LookupTable correction{{0.0}, {1.0}};  // sigma_u over sigma of the signal, over free wind [m/s]
};

/// Turbulence intensity of one signal that follows the wind speed:
///   U = speed_factor mean,   TI = c(U) sqrt((std / mean)^2 - added_intensity^2),
/// mean and standard deviation over the last T by the same window and detrending as the lidar's. A
/// deficit in proportion to the wind leaves TI as it is. No estimate before T has passed, with
/// fewer samples than MinimumFill asks for, for a mean not above 0 and where less is left than was
/// added.
class SignalIntensity {
 public:
  struct State {
    SpeedStatistics window;
    double next_sample_s = 0.0;
    IntensityEstimate estimate;
    void visit(StateArchive& a) { a(window), a(next_sample_s), a(estimate); }
  };

  explicit SignalIntensity(const SignalIntensityParams& params) : params_(params) {}
  State initial_state() const;
  /// `speed_mps`: not a number where there is none. Every controller step; takes a sample when one
  /// is due.
  const IntensityEstimate& step(double speed_mps, double time_s, State& state) const noexcept;

 private:
  IntensityEstimate estimate(double time_s, const State& state) const noexcept;

  SignalIntensityParams params_;
};

}  // namespace lac
