// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/design_page.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostCurves = 6;  // as many colours as a page has
constexpr std::size_t kBinsPerDecade = 12;
constexpr double kLeastCoherence = 1e-2;  // a logarithmic axis has no room for less

std::vector<std::size_t> shown_speeds(std::size_t count) {
  std::vector<std::size_t> shown;
  const std::size_t n = std::min(count, kMostCurves);
  for (std::size_t i = 0; i < n; ++i) shown.push_back(n == 1 ? 0 : i * (count - 1) / (n - 1));
  return shown;
}

ReportSpectrum line(const std::string& name, int run, const CorrelationCurve& curve,
                    const std::vector<double>& values) {
  ReportSpectrum s{name, run, {}, {}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] < kLeastCoherence) break;
    s.frequency_hz.push_back(curve.frequency_hz(i));
    s.density.push_back(values[i]);
  }
  return s;
}

std::vector<double> low_pass_gain(const CorrelationCurve& curve, const LowPassDesign& filter) {
  std::vector<double> gain;
  for (std::size_t i = 0; i < curve.k1_radpm.size(); ++i)
    gain.push_back(gain_of(filter, curve.frequency_hz(i)));
  return gain;
}

ReportSpectrum line(const std::string& name, int run, const std::vector<double>& frequency_hz,
                    std::vector<double> density_radps) {
  for (double& d : density_radps) d *= rpm_from_radps(1.0) * rpm_from_radps(1.0);
  return {name, run, frequency_hz, std::move(density_radps)};
}

void add_flown(const FlownRuns& runs, const std::string& name, int run,
               ReportSpectrumPanel& panel) {
  const auto add = [&](const std::string& what, const auto& files) {
    const Spectrum s = log_binned(flown_rotor_speed(files, runs.run_in_s), kBinsPerDecade);
    panel.series.push_back(line(what + name, run, s.frequency_hz, s.density));
  };
  add("flown, feedback only, ", runs.feedback_only);
  add("flown, lidar-assisted, ", runs.assisted);
}

ReportSpectrumPanel flown_coherence_panel(const DesignResult& r,
                                          const std::vector<std::size_t>& shown) {
  ReportSpectrumPanel panel{"Squared coherence as flown, and of the model (grey)", "-", {}};
  for (const FlownLidar& flown : r.flown) {
    const auto& speeds = r.curves.speeds_mps();
    const auto speed =
        static_cast<std::size_t>(std::ranges::find(speeds, flown.mean_speed_mps) - speeds.begin());
    const auto place = std::ranges::find(shown, speed);
    if (place == shown.end()) continue;
    const std::string name = format_value(flown.mean_speed_mps, 1) + " m/s";
    const CorrelationCurve curve = r.curves.curve(speed);
    panel.series.push_back({name, static_cast<int>(place - shown.begin()),
                            flown.spectrum.frequency_hz, flown.spectrum.coherence});
    panel.series.push_back(line("model, " + name, kAllRuns, curve, curve.coherence()));
  }
  return panel;
}

/// Of the shown wind speeds that are above rated.
ReportSpectrumPanel rotor_speed_panel(const DesignResult& r,
                                      const std::vector<std::size_t>& shown) {
  ReportSpectrumPanel panel{
      "Rotor speed, predicted: lidar-assisted (lines), feedback only and the limit (grey)",
      "rpm²/Hz",
      {}};
  for (std::size_t i = 0; i < r.closed_loop->points.size(); ++i) {
    const ClosedLoopPoint& point = r.closed_loop->points[i];
    const auto place = std::ranges::find(shown, point.speed);
    const std::string name = format_value(point.mean_speed_mps, 1) + " m/s";
    const int run = place == shown.end() ? kAllRuns : static_cast<int>(place - shown.begin());
    for (const FlownRuns& runs : r.design.flown)
      if (runs.mean_speed_mps == point.mean_speed_mps) add_flown(runs, name, run, panel);
    if (run == kAllRuns) continue;
    const RotorSpeedPrediction& p = r.closed_loop->predictions[i];
    const std::vector<double>& f_hz = p.frequency_hz();
    panel.series.push_back(line("feedback only, " + name, kAllRuns, f_hz, p.feedback_only()));
    panel.series.push_back(line("limit, " + name, kAllRuns, f_hz, p.least()));
    panel.series.push_back(line(name, run, f_hz, p.assisted(point.designed)));
  }
  return panel;
}

template <class Value>
ReportResult row(const DesignResult& r, const std::vector<std::size_t>& shown, std::string name,
                 std::string unit, int decimals, const Value& value) {
  ReportResult result{std::move(name), std::move(unit), {}, kNaN, decimals, Better::kNeither};
  for (const std::size_t i : shown) result.values.push_back(value(r.points[i]));
  return result;
}

}  // namespace

HtmlReport design_page(const DesignResult& r) {
  const std::vector<std::size_t> shown = shown_speeds(r.points.size());
  HtmlReport page;
  page.title = "Feedforward from the correlation of lidar and rotor: " + r.design.name;
  page.metadata = {{"Turbulence", describe_turbulence(r.design.turbulence)},
                   {"Lidar", describe(r.design.lidar)},
                   {"Model", describe_model(r.design)}};
  ReportSpectrumPanel coherence{"Squared coherence of lidar and rotor", "-", {}};
  ReportSpectrumPanel gain{"|G_RL| (lines) and the low-pass with this cut-off (grey)", "-", {}};
  for (std::size_t n = 0; n < shown.size(); ++n) {
    const FeedforwardPoint& p = r.points[shown[n]];
    const CorrelationCurve curve = r.curves.curve(shown[n], p.first_plane);
    const std::string name = format_value(p.mean_speed_mps, 1) + " m/s";
    const int run = static_cast<int>(n);
    page.runs.push_back(name);
    coherence.series.push_back(line(name, run, curve, curve.coherence()));
    gain.series.push_back(line(name, run, curve, curve.gain()));
    gain.series.push_back(
        line("low-pass, " + name, kAllRuns, curve, low_pass_gain(curve, p.low_pass)));
  }
  page.spectra = {coherence, gain};
  if (!r.flown.empty()) page.spectra.push_back(flown_coherence_panel(r, shown));
  if (r.closed_loop) page.spectra.push_back(rotor_speed_panel(r, shown));
  using Point = FeedforwardPoint;
  page.results = {
      row(r, shown, "Cut-off", "Hz", 4, [](const Point& p) { return p.cutoff_hz; }),
      row(r, shown, "Smallest detectable eddy, 2π/k0.5", "m", 0,
          [](const Point& p) { return p.figures.smallest_eddy_m().value_or(kNaN); }),
      row(r, shown, "Nearest gate in use", "m", 1, [](const Point& p) { return p.nearest_gate_m; }),
      row(r, shown, "Lead time", "s", 2, [](const Point& p) { return p.lead_s; }),
      row(r, shown, "Required by filter, actuator, scan", "s", 2,
          [](const Point& p) { return p.needed_s; }),
      row(r, shown, "Buffer", "s", 2, [](const Point& p) { return p.buffer_s(); }),
      row(r, shown, "Estimate late by (not in the buffer)", "s", 2,
          [](const Point& p) { return p.late_s; })};
  for (const Point& p : r.points) {
    if (!p.is_usable) {
      page.notes.push_back("At " + format_value(p.mean_speed_mps, 1) +
                           " m/s no gate leads enough: the feedforward stays off.");
    }
  }
  return page;
}

}  // namespace lac::sim
