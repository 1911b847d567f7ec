// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/html_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sim_harness/output/page_parts.hpp"
#include "sim_harness/output/report_data.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {

extern const char kReportPage[];  // report_page.html with style and scripts, made by the build

namespace {

constexpr double kNegligible = 0.001;  // a change below 0.1 % is neither better nor worse
constexpr int kRunColours = 6;         // page_style.css has as many

const char* verdict(const ReportResult& row) {
  if (!std::isfinite(row.relative_change)) return "none";
  if (row.better == Better::kNeither || std::abs(row.relative_change) < kNegligible) return "even";
  return (row.relative_change < 0.0) == (row.better == Better::kLower) ? "better" : "worse";
}

std::string change_html(const ReportResult& row, double widest) {
  return std::string("<td class=\"change ") + verdict(row) + "\">" +
         bar_html(row.relative_change, widest) +
         displayed_number(format_change(row.relative_change)) + "</td>";
}

std::string result_row_html(const ReportResult& row, bool with_change, double widest) {
  std::string html = "<tr><th scope=\"row\" data-unit=\"" + html_text(row.unit) + "\">" +
                     html_text(row.quantity) + "</th><td class=\"unit\">" + html_text(row.unit) +
                     "</td>";
  for (const double value : row.values) {
    html += "<td>" + displayed_number(format_value(value, row.decimals)) + "</td>";
  }
  if (with_change) html += change_html(row, widest);
  return html + "</tr>\n";
}

std::string results_html(const HtmlReport& report) {
  std::string html =
      "<div class=\"table-wrap\"><table class=\"sortable\">\n<thead><tr><th "
      "scope=\"col\">Quantity</th>"
      "<th scope=\"col\" class=\"unit\">Unit</th>";
  for (std::size_t run = 0; run < report.runs.size(); ++run) {
    html += "<th scope=\"col\"><span class=\"swatch\" style=\"border-color:var(--run-" +
            std::to_string(run % kRunColours) + ")\"></span>" + html_text(report.runs[run]) +
            "</th>";
  }
  const bool with_change = report.runs.size() > 1;
  if (with_change) html += "<th scope=\"col\">Relative change</th>";
  html += "</tr></thead>\n<tbody>\n";
  double widest = 0.0;
  for (const ReportResult& row : report.results) {
    if (std::isfinite(row.relative_change))
      widest = std::max(widest, std::abs(row.relative_change));
  }
  for (const ReportResult& row : report.results) html += result_row_html(row, with_change, widest);
  return html + "</tbody></table></div>";
}

std::string notes_html(const HtmlReport& report) {
  std::vector<std::string> notes = report.notes;
  const std::size_t factor = thinning_factor(report);
  if (factor > 1) {
    notes.push_back("Time traces on this page show the minimum and the maximum of every " +
                    std::to_string(2 * factor) + " samples.");
  }
  if (notes.empty()) return {};
  return "<section aria-labelledby=\"notes-heading\"><h2 id=\"notes-heading\">Notes</h2>\n" +
         list_html(notes) + "</section>";
}

void require_run(const HtmlReport& report, const std::string& name, int run) {
  if (run >= kAllRuns && run < static_cast<int>(report.runs.size())) return;
  throw Error("report: series '" + name + "' belongs to run " + std::to_string(run) +
              ", but there are " + std::to_string(report.runs.size()) + " runs");
}

void require_length(const std::string& what, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  throw Error("report: " + what + " has " + std::to_string(found) + " values, expected " +
              std::to_string(expected));
}

void validate(const HtmlReport& report) {
  for (const ReportResult& row : report.results) {
    require_length("result '" + row.quantity + "'", row.values.size(), report.runs.size());
  }
  std::size_t samples = 0;
  for (const ReportTracePanel& panel : report.traces) {
    for (const ReportTrace& trace : panel.series) {
      require_run(report, trace.name, trace.run);
      if (samples == 0) samples = trace.values.size();
      require_length("trace '" + trace.name + "' of '" + panel.title + "'", trace.values.size(),
                     samples);
    }
  }
  if (samples > 0 && !(report.time_step_s > 0.0)) {
    throw Error("report: the time step of the traces is not above zero");
  }
  for (const ReportSpectrumPanel& panel : report.spectra) {
    for (const ReportSpectrum& s : panel.series) {
      require_run(report, s.name, s.run);
      require_length("spectrum '" + s.name + "' of '" + panel.title + "'", s.density.size(),
                     s.frequency_hz.size());
    }
  }
}

}  // namespace

std::string html_report(const HtmlReport& report) {
  validate(report);
  return filled_page(kReportPage, {{"title", html_text(report.title)},
                                   {"metadata", metadata_html(report.metadata)},
                                   {"results", results_html(report)},
                                   {"notes", notes_html(report)},
                                   {"data", report_json(report)}});
}

void write_html_report(const std::filesystem::path& path, const HtmlReport& report) {
  write_page(path, html_report(report));
}

}  // namespace lac::sim
