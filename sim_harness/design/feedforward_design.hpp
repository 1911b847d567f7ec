// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/lookup_table.hpp"
#include "sim_harness/design/figures_of_merit.hpp"
#include "sim_harness/design/filter_fit.hpp"
#include "sim_harness/design/lidar_volumes.hpp"

namespace lac::sim {

/// What the cut-off of the first-order low-pass is taken from.
enum class CutoffRule {
  kAtMinus3dB,  // where |G_RL| is -3 dB (GUO section 3.4)
  kClosestFit,  // least squares over the whole curve
  kLeastLeft,   // what leaves least of the rotor's wind within the lead there is (filter_fit.hpp)
};

/// What else delays the pitch; the numbers of the FFP and LDP input files.
struct FeedforwardTiming {
  double delay_frequency_hz = 0.08;
  double actuator_frequency_hz = 1.0;
  double actuator_damping = 0.7;
  LookupTable buffer_trim_s{{0.0}, {0.0}};  // over the mean wind speed
  double scan_time_s = 1.0;                 // window of the average
  double lead_margin_s = 0.1;  // a gate is used if its lead is longer than needed by this
  int filter_order = 1;        // 1: cut-off by its rule; 2: always what leaves least
  bool trim_lateness = false;  // the buffer also makes up for the lateness of the estimate
};

/// The feedforward at one mean wind speed. T_buffer = T_lead - T_filter - T_actuator - T_window/2 +
/// trim (GUO eq. 40), T_lead = distance of the nearest gate in use / U.
struct FeedforwardPoint {
  double mean_speed_mps = 0.0;
  std::size_t first_plane = 0;  // nearer ones are left out: their wind arrives too soon
  double nearest_gate_m = 0.0;
  /// false: not even the farthest gate leads enough; figures of all gates (of a fit, of the most
  /// that have a cut-off)
  bool is_usable = true;
  FiguresOfMerit figures;
  double cutoff_hz = 0.0;  // of the gain, by its rule
  LowPassDesign low_pass;  // order 1: with this cut-off
  double lead_s = 0.0;
  double filter_s = 0.0;
  double actuator_s = 0.0;
  double half_window_s = 0.0;
  double late_s = 0.0;  // of the estimate itself at the cut-off; FFP knows of it by a trim alone
  double trim_s = 0.0;  // of the template, less the lateness if it is made up for
  double share_left = 0.0;  // of the wind's variance; of the Wiener filter at least
  double needed_s = 0.0;    // filter, actuator and half a window, less the trim
  double buffer_s() const { return lead_s - needed_s; }
};

/// The cut-off at each wind speed with the gates that arrive in time. The nearest gate is left out
/// while its lead is below what its own cut-off needs (GUO Fig. 8). Throws lac::Error where the
/// gain does not give a cut-off; a fit leaves such a set of gates out while there is another.
std::vector<FeedforwardPoint> design_feedforward(const CorrelationCurves& curves,
                                                 const LidarVolumes& lidar, CutoffRule rule,
                                                 const FeedforwardTiming& timing);

}  // namespace lac::sim
