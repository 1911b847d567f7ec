// SPDX-License-Identifier: Apache-2.0
// The figures of a run: what is told of each channel of a recording, in tables of any kind.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim_harness/analysis/rainflow.hpp"
#include "sim_harness/analysis/statistics.hpp"
#include "sim_harness/output/recording.hpp"

namespace lac::sim {

struct FigureOptions {
  double from_s = -std::numeric_limits<double>::infinity();  // samples before: run-in, left out
  double to_s = std::numeric_limits<double>::infinity();     // samples from here on left out
  std::vector<double> woehler_exponents{4.0, 10.0};
  ReferenceCycles reference = ReferenceCycles::kOneHertz;
  RainflowRule counting = RainflowRule::kAstm;

  DelRule del_rule() const { return {reference, counting}; }
  DelConvention convention(double woehler_exponent) const {
    return {woehler_exponent, reference, counting};
  }
};

/// Columns without unit that say in words what the loads of a table of runs are (DelRule).
inline constexpr const char* kDelReferenceColumn = "del_reference";
inline constexpr const char* kDelRainflowColumn = "del_rainflow";

/// All values in the unit of the channel, times in those of the recording. If samples are not
/// finite there are no figures: the values are NaN.
struct ChannelFigures {
  TableChannel channel;
  std::size_t not_finite = 0;  // samples
  Statistics statistics;
  double min_time_s = 0.0;
  double max_time_s = 0.0;
  std::vector<double> damage_equivalent;  // one per exponent of the options
  std::optional<double> travel;           // of pitch angles
  std::optional<double> energy_kWh;       // of powers: mean times duration
};

/// A pitch angle: a name that begins with BldPitch or PtchPM, in deg or rad.
bool is_pitch_angle(const TableChannel& channel);

/// kWh per hour and unit of a power in W, kW or MW; none for other channels.
std::optional<double> kilowatts_per_unit(const TableChannel& channel);

/// Number of samples times the step: what DEL, energy and travel are of.
double figures_duration_s(const Recording& recording, const FigureOptions& options);

/// Of every channel in its order, or of those named (an empty list: all). Throws lac::Error: a name
/// that is not there, with the ones that are; fewer than two samples between from_s and to_s.
std::vector<ChannelFigures> channel_figures(const Recording& recording,
                                            const FigureOptions& options,
                                            const std::vector<std::string>& names = {});

/// One number of a run: a column of a table with one row per run.
struct NamedFigure {
  std::string name;  // "TwrBsMyt_mean", _std, _min, _min_time, _max, _max_time, _del4, _travel,
                     // "GenPwr_energy"
  std::string unit;  // "kNm", "kWh"

  double value = 0.0;

  /// "TwrBsMyt_mean [kNm]".
  std::string header() const { return name + " [" + unit + "]"; }
};

/// The same figures side by side, always in the same order.
std::vector<NamedFigure> named_figures(const std::vector<ChannelFigures>& figures,
                                       const FigureOptions& options);

}  // namespace lac::sim
