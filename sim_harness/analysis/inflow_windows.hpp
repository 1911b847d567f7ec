// SPDX-License-Identifier: Apache-2.0
// How a wind speed measured up-wind goes with a load, window by window, and what is typical of a
// class of windows (G18 section 2.2, Table 1).
#pragma once

#include <span>
#include <vector>

#include "sim_harness/analysis/correlation.hpp"
#include "sim_harness/analysis/operating_mode.hpp"

namespace lac::sim {

/// Series of one length and step.
struct InflowSeries {
  double start_s = 0.0;
  double time_step_s = 0.25;
  std::vector<double> wind;  // [m/s], NaN where there is none
  std::vector<double> load;  // any unit
  std::vector<double> power;
  std::vector<double> pitch;
};

struct InflowWindow {
  double start_s = 0.0;
  double speed_mps = 0.0;  // mean wind
  double intensity = 0.0;  // standard deviation over mean of the wind in the window
  OperatingMode mode = OperatingMode::kMixed;
  CorrelationPeak peak;         // of the load behind the wind
  double time_scale_s = 0.0;    // integral time scale of the wind; NaN: none in the window
  double length_scale_m = 0.0;  // times the mean wind
};

struct InflowWindows {
  std::vector<InflowWindow> windows;
  std::size_t incomplete = 0;  // windows with a gap, or whose load ends before the last lag
};

/// Throws lac::Error if the series differ in length, or as moving_windows().
InflowWindows inflow_windows(const InflowSeries& series, const MovingWindow& window,
                             const LagRange& lags, const ModeRule& rule);

/// Of the values of a class: quartiles (linear between order statistics) and the fullest bin of a
/// histogram. All NaN if there is none.
struct Typical {
  double lower_quartile = 0.0;
  double median = 0.0;
  double upper_quartile = 0.0;
  double bin_from = 0.0;
  double bin_to = 0.0;
  double bin_share = 0.0;  // of the values
};

/// Bins from whole multiples of the width on; values that are not finite are left out.
Typical typical(std::span<const double> values, double bin_width);

}  // namespace lac::sim
