// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/check_report.hpp"

#include <algorithm>
#include <cctype>

#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

constexpr const char* kComponents[] = {"u", "v", "w"};
constexpr int kMostListed = 20;
constexpr double kLeastCoherence = 1e-3;
constexpr int kFound = 0, kTheory = 1;  // runs of the page

std::string separation(const CheckCurve& curve) {
  return curve.dz_m == 0.0 ? format_value(curve.dy_m, 1) + " m across"
                           : format_value(curve.dz_m, 1) + " m up";
}

std::string name_of(const CheckCurve& curve) {
  const std::string component = kComponents[curve.component];
  if (curve.dy_m == 0.0 && curve.dz_m == 0.0) return "spectrum of " + component;
  return "root coherence of " + component + ", " + separation(curve);
}

std::string verdict(const TheoryCheck& check, const CheckSettings& settings) {
  const std::string tests = std::to_string(check.tests) + " tests from " +
                            format_value(check.lowest_hz, 4) + " to " +
                            format_value(check.highest_hz, 3) + " Hz";
  if (check.passed()) {
    return tests + ": all inside (" + format_value(100.0 * settings.confidence, 1) +
           " % of fields of this theory pass)\n";
  }
  return tests + ": " + std::to_string(check.outside) + " outside\n";
}

std::string outside_line(const CheckCurve& curve, const CheckPoint& p) {
  return "  outside: " + name_of(curve) + " at " + format_value(p.frequency_hz, 4) +
         " Hz: " + format_value(p.found, 4) + ", theory " + format_value(p.expected, 4) +
         ", 95 % from " + format_value(p.low, 4) + " to " + format_value(p.high, 4) + "\n";
}

/// What is drawn of a line: a logarithmic axis has no room for less.
ReportSpectrum line(const CheckCurve& curve, const char* name, int run, double CheckPoint::*value,
                    double least) {
  ReportSpectrum s{name, run, {}, {}};
  for (const CheckPoint& p : curve.points) {
    if (p.*value < least) continue;
    s.frequency_hz.push_back(p.frequency_hz);
    s.density.push_back(p.*value);
  }
  return s;
}

/// Found and theory each with a colour of its own, the band grey.
ReportSpectrumPanel panel(const CheckCurve& curve, const std::string& unit, double least) {
  std::string title = name_of(curve);
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return {title,
          unit,
          {line(curve, "field", kFound, &CheckPoint::found, least),
           line(curve, "theory", kTheory, &CheckPoint::expected, least),
           line(curve, "95 % from", kAllRuns, &CheckPoint::low, least),
           line(curve, "95 % to", kAllRuns, &CheckPoint::high, least)}};
}

/// Theory has something to show.
bool is_coherent(const CheckCurve& curve) {
  return std::any_of(curve.points.begin(), curve.points.end(),
                     [](const CheckPoint& p) { return p.expected > kLeastCoherence; });
}

ReportResult sigma_row(const CheckPoint& p, int component, double mean_speed_mps) {
  const double percent = 100.0 / mean_speed_mps;
  return {std::string("Turbulence intensity of ") + kComponents[component] + " (95 % from " +
              format_value(p.low * percent, 2) + " to " + format_value(p.high * percent, 2) + ")",
          "%",
          {p.found * percent, p.expected * percent},
          p.found / p.expected - 1.0,
          2,
          Better::kNeither};
}

}  // namespace

std::string check_table(const TheoryCheck& check, const CheckTitle& title,
                        const CheckSettings& settings) {
  TextTable table({"component", "std [m/s]", "theory", "95 % from", "to", "TI", "theory"});
  for (int c = 0; c < 3; ++c) {
    const CheckPoint& p = check.sigmas[c];
    const double percent = 100.0 / title.mean_speed_mps;
    table.add_row({kComponents[c], format_value(p.found, 3), format_value(p.expected, 3),
                   format_value(p.low, 3), format_value(p.high, 3),
                   format_value(p.found * percent, 2) + " %",
                   format_value(p.expected * percent, 2) + " %"});
  }
  std::string text = title.wind + " against " + title.theory + "\n" + table.text();
  for (int c = 0; c < 3; ++c) {
    if (!check.sigmas[c].inside)
      text += "  outside: standard deviation of " + std::string(kComponents[c]) + "\n";
  }
  int listed = 0;
  for (const auto* curves : {&check.spectra, &check.coherences}) {
    for (const CheckCurve& curve : *curves) {
      for (const CheckPoint& p : curve.points) {
        if (!p.inside && ++listed <= kMostListed) text += outside_line(curve, p);
      }
    }
  }
  if (listed > kMostListed)
    text += "  ... and " + std::to_string(listed - kMostListed) + " more bands\n";
  return text + verdict(check, settings);
}

HtmlReport check_page(const TheoryCheck& check, const CheckTitle& title,
                      const CheckSettings& settings) {
  HtmlReport page;
  page.title = "Wind against theory";
  page.metadata = {{"Wind", title.wind},
                   {"Theory", title.theory},
                   {"Points", std::to_string(check.lattice_points)},
                   {"Verdict", verdict(check, settings)}};
  page.runs = {"field", "theory"};
  for (int c = 0; c < 3; ++c)
    page.results.push_back(sigma_row(check.sigmas[c], c, title.mean_speed_mps));
  for (const CheckCurve& curve : check.spectra)
    page.spectra.push_back(panel(curve, "m²/s²/Hz", 0.0));
  for (const CheckCurve& curve : check.coherences) {
    if (is_coherent(curve)) page.spectra.push_back(panel(curve, "-", kLeastCoherence));
  }
  page.notes = {
      "Means over bands of frequencies and all points. The 95 % lines count with the number of "
      "frequencies and with the correlation of the points; one band in twenty lies outside of them "
      "by chance. The change is that of the field from the theory.",
      "Coherences that theory has none of are tested, too, but not drawn.",
      "A test fails beyond limits at which all tests together pass with " +
          format_value(100.0 * settings.confidence, 1) + " % probability, widened by " +
          format_value(100.0 * settings.spectrum_allowance, 1) +
          " % of the theory in spectra and " + format_value(settings.coherence_allowance, 3) +
          " in coherence."};
  return page;
}

}  // namespace lac::sim
