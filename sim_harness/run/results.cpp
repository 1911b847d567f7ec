// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/results.hpp"

#include <cmath>

#include "sim_harness/analysis/statistics.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

ReportResult row(const std::vector<FlightFigures>& flights, double FlightFigures::*figure,
                 const char* quantity, const char* unit, int decimals, Better better) {
  ReportResult r;
  r.quantity = quantity;
  r.unit = unit;
  for (const FlightFigures& f : flights) r.values.push_back(f.*figure);
  if (r.values.size() > 1) r.relative_change = relative_change(r.values.back(), r.values.front());
  r.decimals = decimals;
  r.better = better;
  return r;
}

}  // namespace

DelConvention tower_convention() {
  return {4.0, ReferenceCycles::kOneHertz};
}

FlightFigures flight_figures(const Recording& recording, double run_in_s) {
  const std::size_t first = recording.first_row_from(run_in_s);
  const auto of = [&](const char* channel) { return statistics(recording.column(channel), first); };
  FlightFigures f;
  const Statistics speed = of("RotSpeed");
  const Statistics power = of("GenPwr");
  f.rotor_speed_std_rpm = speed.standard_deviation;
  f.rotor_speed_max_rpm = speed.max;
  f.pitch_rate_std_degps = of("BldPitchRate").standard_deviation;
  f.power_std_kW = power.standard_deviation;
  f.power_mean_kW = power.mean;
  const std::vector<double> moment_kNm = recording.column("TwrBsMyt");
  f.tower_base_del_MNm = 1e-3 * damage_equivalent_load(std::span(moment_kNm).subspan(first),
                                                       recording.time_step_s(), tower_convention());
  return f;
}

double relative_change(double value, double reference) {
  return (value - reference) / std::abs(reference);
}

std::vector<ReportResult> result_rows(const std::vector<FlightFigures>& flights) {
  using F = FlightFigures;
  return {
      row(flights, &F::rotor_speed_std_rpm, "Rotor speed, standard deviation", "rpm", 4,
          Better::kLower),
      row(flights, &F::rotor_speed_max_rpm, "Rotor speed, maximum", "rpm", 3, Better::kLower),
      row(flights, &F::pitch_rate_std_degps, "Pitch rate, standard deviation", "deg/s", 4,
          Better::kLower),
      row(flights, &F::power_std_kW, "Power, standard deviation", "kW", 1, Better::kLower),
      row(flights, &F::power_mean_kW, "Power, mean", "kW", 1, Better::kHigher),
      row(flights, &F::tower_base_del_MNm, "Tower-base moment, damage-equivalent *", "MNm", 3,
          Better::kLower),
  };
}

std::string result_table(const std::vector<std::string>& names,
                         const std::vector<ReportResult>& rows) {
  std::vector<std::string> header{"", "unit"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.push_back(names[i]);
    if (i > 0) header.push_back("change");
  }
  TextTable table(header);
  for (const ReportResult& r : rows) {
    std::vector<std::string> cells{r.quantity, r.unit};
    for (std::size_t i = 0; i < r.values.size(); ++i) {
      cells.push_back(format_value(r.values[i], r.decimals));
      if (i > 0) cells.push_back(format_change(relative_change(r.values[i], r.values[0])));
    }
    table.add_row(cells);
  }
  return table.text() + "* " + tower_convention().text() + "\n";
}

}  // namespace lac::sim
