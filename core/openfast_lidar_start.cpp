// SPDX-License-Identifier: Apache-2.0
// What is read and checked before the first step.
#include <cmath>

#include "core/error.hpp"
#include "core/openfast_lidar.hpp"

namespace lac {
namespace {

constexpr int kFirst = kOpenFastLidarBlock.first;

void refuse_needless_keys(InputFile& in) {
  for (const char* key : {"NumberOfBeams", "BeamAzimuth", "BeamElevation", "GateRanges",
                          "LidarPosition", "NumberOfGates"}) {
    if (in.has(key)) {
      in.fail(key, "not with LidarLayout openfast: OpenFAST's block says it itself; leave it out");
    }
  }
}

void require_key(InputFile& in, const char* key, const char* hint) {
  if (!in.has(key)) in.fail(key, std::string("missing, expected ") + hint);
}

std::string record(const SwapReader& swap, int offset) {
  return "record " + std::to_string(kFirst + offset) + " is " + shortest(swap.at(kFirst + offset));
}

void require_sensor(const SwapReader& swap, const std::string& where) {
  namespace off = openfast_lidar;
  const OpenFastHeader header = read_openfast_header(swap);
  const std::string found = where + ": found " + record(swap, off::kSensorType);
  if (header.sensor_type == 0) {
    throw Error(found +
                " (no lidar), expected 1 (single point) or 3 (pulsed): set SensorType in the "
                "InflowWind file of OpenFAST 3.5 or later, and LidarLayout openfast in the "
                "master's input file, which passes the records on");
  }
  if (header.sensor_type == 2) {
    throw Error(found +
                " (continuous wave), expected 1 (single point) or 3 (pulsed): OpenFAST aims type "
                "2 at the ground below its focus and returns about half the wind speed. Set "
                "SensorType in the InflowWind file");
  }
  if (header.sensor_type != 1 && header.sensor_type != 3) {
    throw Error(found + ", expected a sensor type, 1 (single point) or 3 (pulsed)");
  }
  if (header.points() == 0) {
    throw Error(where + ": found " + record(swap, off::kNumberOfBeams) + " (beams) and " +
                record(swap, off::kNumberOfGates) +
                " (gates), expected 1 and 1 to 5 or the reverse");
  }
}

void require_point_ahead(const SwapReader& swap, const OpenFastLidarParams& p) {
  const int points = read_openfast_header(swap).points();
  std::string found;
  for (int i = 0; i < points; ++i) {
    const double x_m = openfast_x(swap, i, points);
    if (p.rotor_position_x_m - x_m >= OpenFastLidar::kRotorClearance_m) return;
    found += (i > 0 ? ", " : "") + shortest(x_m);
  }
  throw Error(p.rotor_at + ": no measured point is ahead of the rotor: found x = " + found +
              " m in the lidar block, expected at least one below " +
              shortest(p.rotor_position_x_m - OpenFastLidar::kRotorClearance_m) +
              " m. FocalDistanceX in the InflowWind file is negative up-wind");
}

void check_interval(const OpenFastLidarParams& p, double time_step_s, Notice& notice) {
  const double steps = p.measurement_interval_s / time_step_s;
  const bool on_grid = std::abs(steps - std::round(steps)) < 1e-4 * steps;
  if (steps < 1.0 - 1e-9 || (p.interpolation_order > 0 && !on_grid)) {
    throw Error(p.interval_at + ": found " + shortest(p.measurement_interval_s) +
                " s, expected a multiple of the time step, " + shortest(time_step_s) +
                " s: OpenFAST measures only at its steps");
  }
  const double share = share_of_measurements_taken(p.measurement_interval_s, time_step_s);
  if (share < 1.0) {
    notice.warn(
        "%s: with %s s OpenFAST takes %.0f %% of the measurements and holds the old one for the "
        "others, because the interval is not exact in binary; 0.25, 0.5 and 1 s are",
        p.interval_at.c_str(), shortest(p.measurement_interval_s).c_str(), 100.0 * share);
  }
}

}  // namespace

OpenFastLidarParams OpenFastLidarParams::read(InputFile& in) {
  refuse_needless_keys(in);
  require_key(in, "InterpolationOrder",
              "InterpOrder of the .fst file (1 or 2), or 0 if DLL_DT is three or more DT");
  require_key(in, "RotorPositionX",
              "x of the rotor centre in OpenFAST's global frame [m], -5.0 for the NREL 5 MW");
  OpenFastLidarParams p;
  p.interpolation_order = in.integer("InterpolationOrder", Range::between(0, 2));
  p.rotor_position_x_m = in.number("RotorPositionX", Range::between(-9.0e4, 9.0e4));
  if (in.has("MeasurementInterval")) {
    p.measurement_interval_s = in.number("MeasurementInterval", Range::positive());
  }
  p.layout_at = in.where("LidarLayout");
  p.interval_at = in.where("MeasurementInterval");
  p.rotor_at = in.where("RotorPositionX");
  return p;
}

void OpenFastLidar::require(const SwapReader& swap, double time_step_s, Notice& notice) const {
  if (!swap.holds(kOpenFastLidarBlock)) {
    throw Error(params_.layout_at + ": openfast needs records " + std::to_string(kFirst) + " to " +
                std::to_string(kOpenFastLidarBlock.last()) + ", the array has " +
                std::to_string(swap.size()) + " known records");
  }
  require_sensor(swap, params_.layout_at);
  require_point_ahead(swap, params_);
  if (params_.measurement_interval_s > 0.0) check_interval(params_, time_step_s, notice);
}

double share_of_measurements_taken(double interval_s, double time_step_s) {
  constexpr double kDuration_s = 600.0;
  constexpr double kMost = 1.0e5;
  const auto intervals = static_cast<std::int64_t>(std::min(kDuration_s / interval_s, kMost));
  std::int64_t due = 0, taken = 0;
  for (std::int64_t k = 1; k <= intervals; ++k) {
    const double due_s = static_cast<double>(k) * interval_s;
    const double t = std::round(due_s / time_step_s) * time_step_s;
    if (std::abs(t - due_s) > 1e-3 * time_step_s) continue;
    ++due;
    if (std::trunc(t / interval_s) * interval_s == t) ++taken;
  }
  return due > 0 ? static_cast<double>(taken) / static_cast<double>(due) : 1.0;
}

}  // namespace lac
