// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sim_harness/analysis/rainflow.hpp"
#include "sim_harness/output/html_report.hpp"
#include "sim_harness/output/recording.hpp"

namespace lac::sim {

/// Figures of one flight, the run-in left out.
struct FlightFigures {
  double rotor_speed_std_rpm = 0.0;
  double pitch_rate_std_degps = 0.0;
  double power_std_kW = 0.0;
  double rotor_speed_max_rpm = 0.0;
  double power_mean_kW = 0.0;
  double tower_base_del_MNm = 0.0;  // 1-Hz damage-equivalent moment, tower_convention()
};

/// m = 4, N_ref = one cycle per second.
DelConvention tower_convention();

/// Throws lac::Error if fewer than two samples are left behind the run-in.
FlightFigures flight_figures(const Recording& recording, double run_in_s);

/// The rows of the result table, one value per flight; changes count from the first.
std::vector<ReportResult> result_rows(const std::vector<FlightFigures>& flights);

/// (value - reference) / |reference| of each flight behind the first.
double relative_change(double value, double reference);

/// The table for the terminal, the convention of the load under it.
std::string result_table(const std::vector<std::string>& names,
                         const std::vector<ReportResult>& rows);

}  // namespace lac::sim
