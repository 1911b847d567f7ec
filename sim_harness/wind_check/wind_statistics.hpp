// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "sim_harness/analysis/statistics.hpp"
#include "sim_harness/output/recording.hpp"
#include "sim_harness/wind/rotor_signals.hpp"

namespace lac::sim {

/// What there is to know of a wind at a glance.
struct WindStatistics {
  RotorWindParams rotor;
  double window_s = 0.0;
  std::array<Statistics, 3> hub;          // u, v, w at the hub [m/s]
  std::array<double, 3> hub_intensity{};  // standard deviation over mean u [-]
  Statistics rews;                        // [m/s]
  Statistics shear_y;                     // [m/s per m]
  Statistics shear_z;
  Statistics intensity;  // TI_R over the time for which the window is full [-]
  /// Exponent of the power law that fits the mean u above and below the hub best, within the rotor
  /// (least squares in log-log); NaN if a mean is not above 0.
  double shear_exponent = 0.0;
  double direction_rad = 0.0;  // of the mean wind at the hub, clockwise seen from above
  double upflow_rad = 0.0;
  RotorSignals signals;
};

/// window_s above the length: the whole length, once.
/// Throws lac::Error as rotor_signals(), or if there are fewer than two samples.
WindStatistics wind_statistics(const WindField& field, const RotorWindParams& rotor,
                               double window_s);

/// A table for the terminal.
std::string statistics_table(const WindStatistics& statistics);

/// Channels RtVAvgxh, RtTI, RtShrHor, RtShrVer and the three components at the hub, for ".outb" or
/// ".csv". RtTI is no number until its window is full.
Recording wind_channels(const WindField& field, const RotorSignals& signals, double hub_height_m);

}  // namespace lac::sim
