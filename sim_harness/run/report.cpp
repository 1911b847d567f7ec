// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/report.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "sim_harness/analysis/spectrum.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

constexpr double kSpectrumBlock_s = 200.0;
constexpr std::size_t kShortestBlock = 256;
constexpr std::size_t kBinsPerDecade = 40;

struct PanelSpec {
  const char* title;
  const char* channel;
  const char* unit;
};
constexpr PanelSpec kTracePanels[] = {{"Rotor speed", "RotSpeed", "rpm"},
                                      {"Pitch angle", "BldPitch1", "deg"},
                                      {"Tower-base fore-aft moment", "TwrBsMyt", "kNm"},
                                      {"Electrical power", "GenPwr", "kW"}};
constexpr PanelSpec kSpectrumPanels[] = {{"Rotor speed", "RotSpeed", "rpm²/Hz"},
                                         {"Pitch rate", "BldPitchRate", "(deg/s)²/Hz"},
                                         {"Tower-base fore-aft moment", "TwrBsMyt", "(kNm)²/Hz"}};

bool has_channels(const Recording& r, std::initializer_list<const char*> names) {
  return std::all_of(names.begin(), names.end(), [&](const char* name) {
    return std::any_of(r.channels().begin(), r.channels().end(),
                       [&](const TableChannel& c) { return c.name == name; });
  });
}

ReportTracePanel wind_panel(const std::vector<FlownController>& flights) {
  ReportTracePanel panel{"Rotor-effective wind speed", "m/s", {}};
  panel.series.push_back({"true", kAllRuns, flights.front().recording.column("RtVAvgxh")});
  for (std::size_t i = 0; i < flights.size(); ++i) {
    if (!flights[i].chain_output) continue;
    std::vector<double> rews = rews_at_arrival(*flights[i].chain_output, flights[i].recording);
    if (std::none_of(rews.begin(), rews.end(), [](double v) { return std::isfinite(v); })) continue;
    panel.series.push_back(
        {"lidar, at arrival (" + flights[i].name + ")", static_cast<int>(i), std::move(rews)});
  }
  return panel;
}

ReportTracePanel trace_panel(const PanelSpec& spec, const std::vector<FlownController>& flights) {
  ReportTracePanel panel{spec.title, spec.unit, {}};
  for (std::size_t i = 0; i < flights.size(); ++i) {
    panel.series.push_back(
        {flights[i].name, static_cast<int>(i), flights[i].recording.column(spec.channel)});
  }
  return panel;
}

ReportSpectrumPanel spectrum_panel(const PanelSpec& spec,
                                   const std::vector<FlownController>& flights, double run_in_s,
                                   std::size_t block) {
  ReportSpectrumPanel panel{spec.title, spec.unit, {}};
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const Recording& r = flights[i].recording;
    const std::vector<double> all = r.column(spec.channel);
    const auto settled = std::span(all).subspan(r.first_row_from(run_in_s));
    Spectrum s = log_binned(welch(settled, r.time_step_s(), block), kBinsPerDecade);
    panel.series.push_back(
        {flights[i].name, static_cast<int>(i), std::move(s.frequency_hz), std::move(s.density)});
  }
  return panel;
}

/// A power of two near kSpectrumBlock_s, at most half of what there is; 0 if that is too little.
std::size_t spectrum_block(std::size_t samples, double time_step_s) {
  const auto wanted = static_cast<std::size_t>(kSpectrumBlock_s / time_step_s);
  const std::size_t block = std::bit_floor(std::min(wanted, samples / 2));
  return block >= kShortestBlock ? block : 0;
}

void add_spectra(const Case& c, const std::vector<FlownController>& flights, HtmlReport& page) {
  const Recording& first = flights.front().recording;
  const std::size_t samples = first.rows() - first.first_row_from(c.time.run_in_s);
  const std::size_t block = spectrum_block(samples, first.time_step_s());
  if (block == 0) {
    page.notes.push_back("The run is too short for spectra.");
    return;
  }
  for (const PanelSpec& spec : kSpectrumPanels) {
    page.spectra.push_back(spectrum_panel(spec, flights, c.time.run_in_s, block));
  }
  const double length_s = static_cast<double>(block) * first.time_step_s();
  page.notes.push_back("Spectra: Welch, blocks of " + format_value(length_s, 1) +
                       " s with 50 % overlap, Hamming window, averaged over bins of equal width "
                       "in log frequency.");
}

}  // namespace

std::vector<double> rews_at_arrival(const Recording& chain, const Recording& time_base) {
  if (!has_channels(chain, {"LidarRews", "LidarRewsLead", "LidarRewsValid"})) {
    return {};
  }
  const std::vector<double> rews = chain.column("LidarRews");
  const std::vector<double> lead_s = chain.column("LidarRewsLead");
  const std::vector<double> valid = chain.column("LidarRewsValid");
  const std::vector<double> window_s = has_channels(chain, {"LidarScanWindow"})
                                           ? chain.column("LidarScanWindow")
                                           : std::vector<double>(rews.size(), 0.0);
  std::vector<double> result(time_base.rows(), std::numeric_limits<double>::quiet_NaN());
  const auto arrival_s = [&](std::size_t i) {
    return chain.start_time_s() + static_cast<double>(i) * chain.time_step_s() + lead_s[i] -
           0.5 * window_s[i];
  };
  for (std::size_t i = 0; i + 1 < rews.size(); ++i) {
    if (valid[i] < 0.5 || valid[i + 1] < 0.5) continue;
    const double from_s = arrival_s(i);
    const double to_s = arrival_s(i + 1);
    for (std::size_t k = time_base.first_row_from(from_s); k < result.size(); ++k) {
      const double t_s =
          time_base.start_time_s() + static_cast<double>(k) * time_base.time_step_s();
      if (t_s >= to_s) break;
      result[k] = rews[i] + (rews[i + 1] - rews[i]) * (t_s - from_s) / (to_s - from_s);
    }
  }
  return result;
}

HtmlReport make_report(const Case& c, const std::vector<FlownController>& flights,
                       const std::vector<ReportResult>& results) {
  HtmlReport page;
  page.title = c.name;
  page.metadata = {{"Turbine", c.turbine.name},
                   {"Wind", describe(c.wind)},
                   {"Lidar", c.lidar ? describe(c.lidar->params) : "none"},
                   {"Duration", format_value(c.time.duration_s, 1) + " s, run-in " +
                                    format_value(c.time.run_in_s, 1) + " s, controller step " +
                                    format_value(c.time.step_s, 4) + " s"}};
  for (const FlownController& f : flights) page.runs.push_back(f.name);
  page.results = results;
  page.time_step_s = c.time.step_s;
  page.run_in_until_s = c.time.run_in_s;
  page.traces.push_back(wind_panel(flights));
  for (const PanelSpec& spec : kTracePanels) page.traces.push_back(trace_panel(spec, flights));
  page.notes.push_back("* " + tower_convention().text());
  add_spectra(c, flights, page);
  return page;
}

}  // namespace lac::sim
