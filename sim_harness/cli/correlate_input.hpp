// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim_harness/analysis/inflow_windows.hpp"
#include "sim_harness/analysis/quality.hpp"

namespace lac::sim {

/// From generator to rotor: J dOmega/dt + ratio M_g, the aerodynamic torque of a rigid drive train
/// without losses, as a wind estimator of a turbine finds it.
struct TorqueAtRotor {
  double inertia_kgm2 = 0.0;  // about the slow shaft, of all that turns; 0: the load as it is
  double gear_ratio = 1.0;    // generator speed over rotor speed
  std::string rotor_speed = "RotSpeed";
};

/// Where the series of `lac correlate` come from and what is done to them first.
struct CorrelateInput {
  std::vector<std::filesystem::path> files;  // of the same time; a channel is looked for in turn
  std::vector<std::string> winds;
  std::string load;
  TorqueAtRotor torque;  // the load is a generator torque [kNm] to be taken there
  std::string power = "GenPwr";
  std::string pitch = "BldPitch1";
  std::string companion;  // of every wind, e.g. its CNR; empty: none
  double companion_min = -17.0;
  double companion_max = 0.0;
  QualityRule wind_rule;  // applied to the winds
  double from_s = 0.0;    // earlier samples are left out
  double rate_hz = 4.0;   // everything is brought to it by means of neighbouring samples
};

struct CorrelatedSeries {
  std::vector<InflowSeries> of_wind;  // one per wind
  std::vector<QualityCount> quality;  // of each wind, at the rate of its file
  std::vector<std::size_t> dropped;   // for their companion
};

/// Rows that are missing count as gaps. Throws lac::Error: a channel that is in none of the files,
/// a rate that the step of a file has no whole number of samples for, files without common
/// time, a torque or rotor speed in other units than kNm and rpm.
CorrelatedSeries read_correlated(const CorrelateInput& input);

}  // namespace lac::sim
