// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "core/lidar_block.hpp"
#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/lidar/range_weighting.hpp"

namespace lac::sim {

/// An object that stands still in the beam: a mast, a hill, another turbine.
struct HardTarget {
  double distance_m = 0.0;        // along the beam
  double cnr_db = 20.0;           // of its echo in a gate centred on it
  bool opaque = true;             // nothing is seen behind it
  int beam = -1;                  // from 0; -1: every beam that points into the window
  double azimuth_min_rad = -kPi;  // window of directions, from up-wind, to the left ...
  double azimuth_max_rad = kPi;
  double elevation_min_rad = -0.5 * kPi;  // ... and upwards
  double elevation_max_rad = 0.5 * kPi;
  double start_s = 0.0;
  double end_s = std::numeric_limits<double>::infinity();

  /// Whether this measurement's beam meets it: its time, beam and direction in frame I.
  bool met_by(const LidarMeasurement& m) const noexcept;
};

/// List `hard_targets`: distance_m and, with defaults, cnr_db (20), opaque (yes), beam (from 1;
/// without it every beam), azimuth_deg, elevation_deg (from, to), start_s, end_s. Throws
/// lac::Error.
std::vector<HardTarget> read_hard_targets(YamlReader& in, const std::string& key);

/// How a gate sees what lies off its centre, as parts of the power it would have there.
struct GateView {
  double echo = 0.0;    // of an echo at the object's distance: the range weighting, 1 at the centre
  double before = 1.0;  // share of the range weighting that lies before the object
};
/// Of a gate with this range weighting, tails included; a point sees an echo within 0.5 m.
GateView gate_view(const RangeWeighting& weighting, double gate_range_m, double object_m) noexcept;

/// Mixes the echo into a gate that holds the wind's speed and CNR. Powers add, and the speed is the
/// centroid of the Doppler spectrum, weighted by them:
///
///   P_o = 10^(cnr_db/10) echo,   P_w = 10^(CNR/10) (opaque: times `before`)
///   v = (P_w v_wind + P_o v_own) / (P_w + P_o),   CNR = 10 log10(P_w + P_o)
///
/// own_speed_mps = n . V_lidar is what the lidar reads off something that stands still.
void mix_in(const HardTarget& target, const GateView& view, double own_speed_mps,
            LidarGate& gate) noexcept;

}  // namespace lac::sim
