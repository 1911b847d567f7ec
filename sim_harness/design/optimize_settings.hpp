// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

/// From one number to another; free if they differ.
struct Interval {
  double low = 0.0, high = 0.0;
  bool is_free() const { return high > low; }
  double middle() const { return 0.5 * (low + high); }
};

/// What may be moved, and what must hold.
struct OptimizeSettings {
  double wind_speed_mps = 16.0;  // of k0.5
  std::vector<int> beams{4};     // numbers to be compared
  int gates = 1;
  Interval azimuth_rad, elevation_rad;  // of the layout
  Interval first_gate_m, last_gate_m;
  int grid = 21;  // points of the map along each free angle
  // Constraints; those not set are not asked for.
  std::optional<double> lead_at_mps;    // the first gate leads enough up to this wind speed
  double largest_half_angle_rad = 1.5;  // between a beam and the axis: the window of the device
  double lowest_gate_m = 0.0;           // over ground
};

/// The keys under `optimize` of a design file (docs/design.md). Throws lac::Error.
OptimizeSettings read_optimize_settings(YamlReader in);

}  // namespace lac::sim
