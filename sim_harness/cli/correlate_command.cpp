// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/correlate_command.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>

#include "core/error.hpp"
#include "sim_harness/cli/correlate_text.hpp"
#include "sim_harness/cli/written_table.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

CorrelateOptions completed(CorrelateOptions o, const CorrelatedSeries& series) {
  if (!o.ranges_m.empty() && o.ranges_m.size() != o.input.winds.size()) {
    throw Error("correlate: " + std::to_string(o.ranges_m.size()) + " ranges for " +
                std::to_string(o.input.winds.size()) + " winds, expected one for each");
  }
  if (o.lags.min_s > o.lags.max_s) {
    throw Error("correlate: --min-delay " + format_value(o.lags.min_s, 2) +
                " s is above --max-delay " + format_value(o.lags.max_s, 2) + " s");
  }
  const double block = o.block_s * o.input.rate_hz;
  if (!(std::round(block) >= kLeastBlock)) {
    throw Error("correlate: --block " + format_value(o.block_s, 2) + " s is " +
                format_value(block, 1) + " samples at --rate " + format_value(o.input.rate_hz, 2) +
                " Hz, expected at least " + std::to_string(kLeastBlock) + " samples");
  }
  if (o.rule.rated_power > 0.0) return o;
  for (const double power : series.of_wind[0].power)
    if (power > o.rule.rated_power) o.rule.rated_power = power;
  return o;
}

void require_availability(const CorrelateOptions& o, const CorrelatedSeries& series) {
  for (std::size_t i = 0; i < series.quality.size(); ++i) {
    const QualityCount& q = series.quality[i];
    if (q.availability() >= o.least_availability) continue;
    throw Error("correlate: '" + o.input.winds[i] + "' is available " +
                percent_text(q.availability(), 1) + " of the time, expected at least " +
                percent_text(o.least_availability, 1) + " (--availability): " + q.text());
  }
}

std::string quality_line(const CorrelatedSeries& series, std::size_t wind,
                         const WindRelation& relation, const CorrelateOptions& o) {
  std::string line = relation.wind + ": " + series.quality[wind].text();
  if (!o.input.companion.empty())
    line += "; " + std::to_string(series.dropped[wind]) + " missing for " + o.input.companion;
  return line + "; " + std::to_string(relation.windows.incomplete) + " windows incomplete\n";
}

/// Median delay of the windows in a mode, those at the edge left out; 0 if that leaves none. None
/// without a window in it.
std::optional<double> delay_in(OperatingMode mode, const InflowWindows& windows) {
  std::vector<double> delays_s;
  bool any = false;
  for (const InflowWindow& w : windows.windows) {
    if (w.mode != mode) continue;
    any = true;
    if (!w.peak.at_edge) delays_s.push_back(w.peak.delay_s);
  }
  if (!any) return std::nullopt;
  return delays_s.empty() ? 0.0 : typical(delays_s, 1.0).median;
}

WindRelation relation_of(const InflowSeries& s, std::size_t wind, const CorrelateOptions& o) {
  WindRelation r;
  r.wind = o.input.winds[wind];
  r.range_m = o.ranges_m.empty() ? 0.0 : o.ranges_m[wind];
  r.windows = inflow_windows(s, o.window, o.lags, o.rule);
  for (const OperatingMode mode : {OperatingMode::kBelowRated, OperatingMode::kAboveRated}) {
    const auto delay_s = delay_in(mode, r.windows);
    if (delay_s) r.modes.push_back({mode, mode_coherence(s, mode, *delay_s, o.rule, o.block_s)});
  }
  return r;
}

void require_windows(const std::vector<WindRelation>& relations, const CorrelatedSeries& series,
                     const CorrelateOptions& o) {
  const auto has_none = [](const WindRelation& r) { return r.windows.windows.empty(); };
  if (!std::ranges::all_of(relations, has_none)) return;
  const InflowSeries& s = series.of_wind[0];
  throw Error("correlate: no complete window: the series have " +
              format_value(static_cast<double>(s.wind.size()) * s.time_step_s, 1) +
              " s, a window of " + format_value(o.window.length_s, 1) + " s and a delay up to " +
              format_value(o.lags.max_s, 1) + " s must be in them without a gap (--window, " +
              "--max-delay, --from, --fill)");
}

}  // namespace

void correlate_command(const CorrelateOptions& options, std::ostream& out) {
  const CorrelatedSeries series = read_correlated(options.input);
  const CorrelateOptions o = completed(options, series);
  require_availability(o, series);
  std::vector<WindRelation> relations;
  std::string notes;
  for (std::size_t i = 0; i < series.of_wind.size(); ++i) {
    relations.push_back(relation_of(series.of_wind[i], i, o));
    notes += quality_line(series, i, relations.back(), o);
  }
  require_windows(relations, series, o);
  out << "correlation and delay of " << o.input.load << " behind the wind, windows of "
      << format_value(o.window.length_s, 1) << " s\n"
      << relation_table(relations, o.intensity_limit) << '\n'
      << coherence_lines(relations, o.confidence) << '\n'
      << notes;
  write_table(o.csv, windows_csv(relations), out);
  write_table(o.spectra, spectra_csv(relations, o.confidence), out);
}

}  // namespace lac::sim
