// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/channel_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/error.hpp"
#include "core/suggest.hpp"

namespace lac::sim {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kSecondsPerHour = 3600.0;

struct RowRange {
  std::size_t first = 0;
  std::size_t end = 0;
};

RowRange rows_between(const Recording& recording, const FigureOptions& o) {
  RowRange range{0, recording.rows()};
  if (std::isfinite(o.from_s)) range.first = recording.first_row_from(o.from_s);
  if (std::isfinite(o.to_s)) range.end = recording.first_row_from(o.to_s);
  if (range.first + 2 <= range.end) return range;
  char text[200];
  const double last_s =
      recording.start_time_s() + static_cast<double>(recording.rows()) * recording.time_step_s();
  std::snprintf(text, sizeof text,
                "fewer than two samples from %g s to %g s: the recording goes from %g s to %g s",
                o.from_s, o.to_s, recording.start_time_s(), last_s);
  throw Error(text);
}

std::vector<std::string> wanted(const Recording& recording, const std::vector<std::string>& names) {
  if (!names.empty()) return names;
  std::vector<std::string> all;
  for (const TableChannel& c : recording.channels()) all.push_back(c.name);
  return all;
}

const TableChannel& channel_named(const Recording& recording, const std::string& name) {
  std::vector<std::string> known;
  for (const TableChannel& c : recording.channels()) {
    if (c.name == name) return c;
    known.push_back(c.name);
  }
  std::string list;
  for (const std::string& k : known) list += " " + k;
  throw Error("no channel '" + name + "'" + did_you_mean(name, known) + "; there are:" + list);
}

ChannelFigures without_figures(ChannelFigures f, const FigureOptions& options) {
  f.statistics = {kNotANumber, kNotANumber, kNotANumber, kNotANumber};
  f.min_time_s = f.max_time_s = kNotANumber;
  f.damage_equivalent.assign(options.woehler_exponents.size(), kNotANumber);
  if (is_pitch_angle(f.channel)) f.travel = kNotANumber;
  if (kilowatts_per_unit(f.channel)) f.energy_kWh = kNotANumber;
  return f;
}

ChannelFigures figures_of(const TableChannel& channel, std::span<const double> series,
                          double start_s, double step_s, const FigureOptions& options) {
  ChannelFigures f;
  f.channel = channel;
  f.not_finite = static_cast<std::size_t>(
      std::count_if(series.begin(), series.end(), [](double x) { return !std::isfinite(x); }));
  if (f.not_finite > 0) return without_figures(std::move(f), options);
  const double duration_s = static_cast<double>(series.size()) * step_s;
  f.statistics = statistics(series);
  f.min_time_s = start_s + static_cast<double>(f.statistics.min_sample) * step_s;
  f.max_time_s = start_s + static_cast<double>(f.statistics.max_sample) * step_s;
  const std::vector<LoadCycle> cycles = rainflow(series, options.counting);
  for (const double m : options.woehler_exponents) {
    f.damage_equivalent.push_back(
        damage_equivalent_load(cycles, duration_s, options.convention(m)));
  }
  if (is_pitch_angle(channel)) f.travel = travel(series);
  if (const auto kilowatts = kilowatts_per_unit(channel))
    f.energy_kWh = *kilowatts * f.statistics.mean * duration_s / kSecondsPerHour;
  return f;
}

std::string short_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

}  // namespace

bool is_pitch_angle(const TableChannel& channel) {
  const bool named = channel.name.starts_with("BldPitch") || channel.name.starts_with("PtchPM");
  return named && (channel.unit == "deg" || channel.unit == "rad");
}

std::optional<double> kilowatts_per_unit(const TableChannel& channel) {
  if (channel.unit == "W") return 1e-3;
  if (channel.unit == "kW") return 1.0;
  if (channel.unit == "MW") return 1e3;
  return std::nullopt;
}

double figures_duration_s(const Recording& recording, const FigureOptions& options) {
  const RowRange range = rows_between(recording, options);
  return static_cast<double>(range.end - range.first) * recording.time_step_s();
}

std::vector<ChannelFigures> channel_figures(const Recording& recording,
                                            const FigureOptions& options,
                                            const std::vector<std::string>& names) {
  const RowRange range = rows_between(recording, options);
  const double start_s =
      recording.start_time_s() + static_cast<double>(range.first) * recording.time_step_s();
  std::vector<ChannelFigures> all;
  for (const std::string& name : wanted(recording, names)) {
    const TableChannel& channel = channel_named(recording, name);
    const std::vector<double> column = recording.column(name);
    const auto series = std::span(column).subspan(range.first, range.end - range.first);
    all.push_back(figures_of(channel, series, start_s, recording.time_step_s(), options));
  }
  return all;
}

std::vector<NamedFigure> named_figures(const std::vector<ChannelFigures>& figures,
                                       const FigureOptions& options) {
  std::vector<NamedFigure> all;
  for (const ChannelFigures& f : figures) {
    const auto add = [&](const std::string& what, const std::string& unit, double value) {
      all.push_back({f.channel.name + "_" + what, unit, value});
    };
    const std::string& unit = f.channel.unit;
    add("mean", unit, f.statistics.mean);
    add("std", unit, f.statistics.standard_deviation);
    add("min", unit, f.statistics.min);
    add("min_time", "s", f.min_time_s);
    add("max", unit, f.statistics.max);
    add("max_time", "s", f.max_time_s);
    for (std::size_t i = 0; i < f.damage_equivalent.size(); ++i)
      add("del" + short_number(options.woehler_exponents[i]), unit, f.damage_equivalent[i]);
    if (f.travel) add("travel", unit, *f.travel);
    if (f.energy_kWh) add("energy", "kWh", *f.energy_kWh);
  }
  return all;
}

}  // namespace lac::sim
