// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/input_file.hpp"
#include "core/lidar_reader.hpp"
#include "ti_estimator/correction.hpp"
#include "ti_estimator/power_level.hpp"
#include "ti_estimator/signal_intensity.hpp"

namespace lac {

// Limits of AveragingTime over ScanTime.
inline constexpr int kFewestSamples = 10;
inline constexpr int kMostSamples = 20000;
// Between two samples of anemometer and rotor-effective wind speed, unless a step takes longer.
inline constexpr double kSignalInterval_s = 0.25;
// Smallest |n_x| of a beam that can give a wind speed, as in LidarReader.
inline constexpr double kSmallestProjection = 0.05;

struct TiEstimatorParams {
  LidarReaderParams reader;

  // Frame L, one per beam: what c_TI is computed for, in either lidar layout.
  std::vector<Vec3> beam_dir_L;
  // Gates with statistics of their own; what a measurement has beyond is not used. The Guo layout
  // takes it from GateRanges.
  int number_of_gates = 10;
  std::vector<double> gate_weights;  // in the means over the gates; empty: 1
  // One full scan: each volume is measured once in it (f_scan = 1/ScanTime).
  double scan_time_s = 1.0;
  // T. S20 compares 600 s and 180 s and schedules the power with 180 s.
  double averaging_time_s = 180.0;
  // Share of the expected samples that a series needs to count. Blades and low signal take a third
  // of a nacelle lidar's samples at times; half of them still give its variance without bias.
  double minimum_fill = 0.5;
  // Take attitude and velocity of the lidar out of the samples.
  bool motion_compensation = true;
  // Slow mean over T of record 24 as wind direction, in c_TI and in the projection. False: the
  // wind blows along x of frame I and c_TI is that of no misalignment.
  bool use_yaw_error = false;
  bool yaw_error_of_ldp = false;   // the wind direction is LDP's (record 3315) instead of record 24
  bool mean_speed_of_ldp = false;  // U is LDP's slow mean (record 3307) instead of the window's

  CorrectionParams correction;
  // Axes of the c_TI table. Outside of them there is no estimate.
  std::vector<double> table_speeds_mps{3, 4, 5, 6.5, 8, 10, 12.5, 15, 18, 22, 27, 33, 40};
  std::vector<double> table_yaw_errors_rad{0.0};

  // Estimates beside the lidar's, none unless asked for.
  bool uncorrected = false;
  SignalIntensityParams anemometer;  // record 27
  SignalIntensityParams turbine;     // record 3771; its correction comes with the estimator
  double rotor_radius_m = 0.0;
  double turbine_cutoff_hz = std::numeric_limits<double>::infinity();  // of record 3771

  IntensitySource power_level_source = IntensitySource::Lidar;
  PowerLevelParams power_level;

  /// Reads all keys and refuses unknown ones. Throws lac::Error.
  static TiEstimatorParams read(InputFile& in);

  StatisticsSpec statistics() const;
  bool has(IntensitySource source) const;
};

}  // namespace lac
