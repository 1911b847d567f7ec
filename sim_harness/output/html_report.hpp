// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace lac::sim {

/// Run index of a series that belongs to all runs, such as the true wind; drawn in grey.
inline constexpr int kAllRuns = -1;

enum class Better { kLower, kHigher, kNeither };

/// One line of the result table.
struct ReportResult {
  std::string quantity;
  std::string unit;
  std::vector<double> values;  // one per run; not finite is shown as "n/a"
  double relative_change = std::numeric_limits<double>::quiet_NaN();  // 0.1 is +10 %
  int decimals = 3;
  Better better = Better::kLower;  // decides the colour of the change
};

struct ReportTrace {
  std::string name;
  int run = kAllRuns;          // index into HtmlReport::runs; gives the colour
  std::vector<double> values;  // not finite leaves a gap
};

struct ReportTracePanel {
  std::string title;
  std::string unit;
  std::vector<ReportTrace> series;
};

struct ReportSpectrum {
  std::string name;
  int run = kAllRuns;
  std::vector<double> frequency_hz;
  std::vector<double> density;
};

struct ReportSpectrumPanel {
  std::string title;
  std::string unit;  // of the density, "rpm²/Hz"
  std::vector<ReportSpectrum> series;
};

/// What stands on the page, from top to bottom. All text is UTF-8 and is escaped on the way.
struct HtmlReport {
  std::string title;
  std::vector<std::pair<std::string, std::string>> metadata;  // name, value
  std::vector<std::string> runs;                              // the baseline first
  std::vector<ReportResult> results;
  double start_time_s = 0.0;             // of every trace
  double time_step_s = 0.0;              // of every trace, > 0
  double run_in_until_s = 0.0;           // traces are shaded up to here: not part of the results
  std::vector<ReportTracePanel> traces;  // all series of one length
  std::vector<ReportSpectrumPanel> spectra;
  std::vector<std::string> notes;

  /// Longer traces are thinned to at most this many values, keeping the minimum and the maximum
  /// of each stretch; a note on the page says so.
  std::size_t most_samples_per_trace = 60000;
};

/// One self-contained page: no other file, no network. Traces are stored as 16-bit levels
/// between their extremes (2.7 bytes per value on disk), so 12 traces of 52800 samples take
/// 1.7 MB. Throws lac::Error if lengths or run indices do not fit together.
std::string html_report(const HtmlReport& report);

/// Writes the page in one step: nothing half-written. Throws lac::Error with file and reason.
void write_html_report(const std::filesystem::path& path, const HtmlReport& report);

}  // namespace lac::sim
