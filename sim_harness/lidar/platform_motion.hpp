// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/lidar/rigid_frame.hpp"

namespace lac::sim {

/// amplitude sin(2 pi t/period + phase), in m or rad.
struct Harmonic {
  double amplitude = 0.0;
  double period_s = 10.0;
  double phase_rad = 0.0;
};

/// One degree of freedom at one time: value in m or rad, and its rate.
struct Motion {
  double value = 0.0;
  double rate = 0.0;
};

/// A degree of freedom over time: mean plus harmonics, or a table between whose rows it runs as a
/// cubic Hermite spline with slopes from the neighbouring rows; the rate is that of this curve.
struct PrescribedMotion {
  double mean = 0.0;
  std::vector<Harmonic> harmonics;
  std::vector<double> time_s;  // rising
  std::vector<double> values;

  Motion at(double time_s) const;
  bool is_still() const { return mean == 0.0 && harmonics.empty() && time_s.empty(); }
  double greatest() const;  // bound on |value|
};

enum PlatformFreedom : std::size_t { kSurge, kSway, kHeave, kRoll, kPlatformPitch, kYaw };

/// How a floating platform carries the turbine: prescribed, so the wind and the turbine do not
/// act on it, and the turbine does not feel it; the lidar does. Surge, sway and heave along x, y
/// and z of frame I, roll, pitch and yaw in the order z-y'-x'' (core/vec3.hpp) about a point on
/// the tower axis.
struct PlatformMotion {
  std::array<PrescribedMotion, 6> freedoms;
  double reference_height_m = 0.0;  // of that point above z = 0

  bool is_still() const;
  /// Frame with its origin in the reference point; exact, omega from the rates of the angles.
  RigidFrame frame_at(double time_s) const;
  /// Bound on the way that a point may go which is at most distance_m from the reference point.
  double greatest_travel_m(double distance_m) const;
  /// Throws lac::Error if a table does not cover 0 ... end_s.
  void require_until(double end_s) const;
};

/// Keys: reference_height_m and either table (file: time_s surge_m sway_m heave_m roll_deg
/// pitch_deg yaw_deg) or maps surge, sway, heave, roll, pitch, yaw with mean, amplitude, period_s,
/// phase_deg (lists; m or deg). Throws lac::Error.
PlatformMotion read_platform_motion(YamlReader& in);

}  // namespace lac::sim
