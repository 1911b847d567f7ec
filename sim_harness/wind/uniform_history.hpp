// SPDX-License-Identifier: Apache-2.0
// What a uniform wind does over time: steady, a step, IEC's deterministic events, or a table. One
// state of eight numbers describes it at any moment, the same eight as in a uniform wind file.
#pragma once

#include <variant>
#include <vector>

namespace lac::sim {

/// The wind at one time of arrival. With V = speed, in frame I at the rotor plane,
///   u' = V ((z/z_hub)^shear_exponent + (shear_y y + shear_z (z - z_hub)) / L) + gust,
/// L a reference length; (u', vertical) is then turned upwards by upflow, and the result turned
/// about the vertical by direction, clockwise seen from above: the wind blows towards
/// -y where direction is between 0 and 180 deg. This is the reading of InflowWind.
struct UniformState {
  double speed_mps = 0.0;
  double direction_rad = 0.0;
  double vertical_mps = 0.0;
  double shear_y = 0.0;         // horizontal linear shear [-]: of the speed over L
  double shear_exponent = 0.0;  // vertical power law [-]
  double shear_z = 0.0;         // vertical linear shear [-]
  double gust_mps = 0.0;        // the same at all heights
  double upflow_rad = 0.0;

  bool operator==(const UniformState&) const = default;
};

struct SteadySpeed {
  double speed_mps = 10.0;
};

/// from_mps before time_s, to_mps once ramp_s has passed, a straight line between.
struct StepSpeed {
  double from_mps = 10.0;
  double to_mps = 11.0;
  double time_s = 60.0;
  double ramp_s = 0.0;
};

/// Extreme operating gust (IEC 61400-1, methods section 14) arriving at start_s.
struct GustSpeed {
  double mean_speed_mps = 18.0;
  double magnitude_mps = 0.0;  // V_gust; eog_magnitude_mps() gives IEC's
  double start_s = 60.0;
};

/// Extreme direction change: within 6 s to a new direction, where it stays.
struct DirectionChange {
  double mean_speed_mps = 18.0;
  double angle_rad = 0.0;  // theta_e with its sign; edc_angle_rad() gives IEC's
  double start_s = 60.0;
};

/// Extreme coherent gust with direction change: both within 10 s, and they stay.
struct CoherentGust {
  double mean_speed_mps = 10.0;
  double gust_mps = 15.0;  // V_cg, the same at all heights
  double angle_rad = 0.0;  // theta_cg with its sign; ecd_angle_rad() gives IEC's
  double start_s = 60.0;
};

/// Extreme wind shear for 12 s, upwards or to the left with positive amplitude.
struct ShearEvent {
  enum class Axis { kVertical, kHorizontal };
  double mean_speed_mps = 18.0;
  double amplitude_mps = 0.0;  // A with its sign; ews_amplitude_mps() gives IEC's
  Axis axis = Axis::kVertical;
  double start_s = 60.0;
};

struct UniformRow {
  double time_s = 0.0;
  UniformState state;
};

/// Straight lines between rows, the first and the last row hold outside. At least one row, times
/// rising.
struct UniformTable {
  std::vector<UniformRow> rows;
};

/// Over the time of arrival at the rotor plane.
using UniformHistory = std::variant<SteadySpeed, StepSpeed, GustSpeed, DirectionChange,
                                    CoherentGust, ShearEvent, UniformTable>;

/// Throws lac::Error, by name, on what cannot be flown.
void check(const UniformHistory& history);

/// shear_exponent goes to every kind but tables, which have their own.
UniformState state_at(const UniformHistory& history, double arrival_s, double shear_exponent);

/// What shears a history ever has.
struct UniformShear {
  bool power_law = false;
  bool any = false;
};
UniformShear shear_of(const UniformHistory& history, double shear_exponent);

}  // namespace lac::sim
