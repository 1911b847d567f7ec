// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/input_file.hpp"
#include "core/lidar_reader.hpp"
#include "ldp/induction_correction.hpp"
#include "ldp/spike_filter.hpp"
#include "ldp/wind_reconstruction.hpp"

namespace lac {

enum class TravelSpeed { Lidar, Turbine };

struct LdpParams {
  LidarReaderParams reader;

  // One full scan. Averaging over it gives every beam the same weight, at the price of half of it
  // as delay (which FFP takes into account).
  double scan_time_s = 1.0;
  // Gates whose wind arrives sooner than the filter and buffer behind need are of no use and only
  // shorten the lead of all others; they are left out. What FFP needs it says itself, in a record;
  // the lead has to be longer by lead_margin_s, and not below required_lead_s in any case.
  double required_lead_s = 0.0;
  double lead_margin_s = 0.1;
  // Speed of travel and so lead times mean little before this much was averaged: not valid yet.
  double settling_time_s = 10.0;
  // Memory: wind that arrives later than this is not stored (slow wind; LDP then reports no data).
  double longest_lead_s = 60.0;
  // Mean that sets the speed of travel: exact mean until then, exponential forgetting after (HM
  // eq. 25 uses ten minutes).
  double mean_speed_window_s = 600.0;
  // Fewer samples in the scan window than this are no estimate.
  int minimum_samples = 4;
  // Without a valid sample for this long the estimate is invalid, whatever is still in store.
  double maximum_age_s = 2.0;
  // Take attitude and velocity of the lidar into account. False: level, straight up-wind, at rest.
  bool motion_compensation = true;

  WindModelParams wind;
  InductionCorrectionParams induction;
  SpikeFilterParams spikes;
  // Turbine: slow mean of the REWS from turbine data (record TurbineRews), which no bias of the
  // lidar reaches; the lidar's as long as there is none.
  TravelSpeed travel = TravelSpeed::Lidar;
  // An estimate that turns invalid is held this long and still counts as valid. 0: gaps are left.
  double bridged_gap_s = 0.0;
  double availability_window_s = 60.0;
  // Below this for availability_alarm_s: told, once. 0: never.
  double availability_limit = 0.0;
  double availability_alarm_s = 60.0;

  /// Reads all keys and refuses unknown ones. Throws lac::Error.
  static LdpParams read(InputFile& in);

  /// Refuses times shorter than a time step. Throws lac::Error with file, line and key.
  void check_time_step(const InputFile& in, double time_step_s) const;

 private:
  /// BridgeGaps, AvailabilityWindow, AvailabilityLimit, AvailabilityAlarmTime.
  void read_availability(InputFile& in);
};

}  // namespace lac
