// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/html_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>

#include "core/error.hpp"
#include "core/part_file.hpp"
#include "sim_harness/output/report_data.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {

extern const char kReportPage[];  // report_page.html with style and scripts, made by the build

namespace {

constexpr double kNegligible = 0.001;  // a change below 0.1 % is neither better nor worse
constexpr int kRunColours = 6;         // report_page.css has as many

std::string escaped(std::string_view text) {
  constexpr std::string_view kSpecial = "&<>\"'";
  constexpr std::array kNames{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string html;
  for (const char c : text) {
    const std::size_t which = kSpecial.find(c);
    which == std::string_view::npos ? html += c : html += kNames[which];
  }
  return html;
}

// As the script writes numbers: a true minus, thousands apart from five digits on.
std::string displayed(std::string number) {
  const bool negative = number.starts_with('-');
  if (negative) number.erase(0, 1);
  const std::size_t digits = std::min(number.find_first_not_of("0123456789"), number.size());
  for (std::size_t at = digits; digits > 4 && at > 3;) number.insert(at -= 3, "\u202f");
  return (negative ? "\u2212" : "") + number;
}

std::string metadata_html(const HtmlReport& report) {
  if (report.metadata.empty()) return {};
  std::string html = "<dl class=\"metadata\">\n";
  for (const auto& [name, value] : report.metadata) {
    html += "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>\n";
  }
  return html + "</dl>";
}

std::string bar_html(double change, double widest) {
  if (!std::isfinite(change) || widest <= 0.0) return {};
  char width[16];
  std::snprintf(width, sizeof width, "%.1f", 50.0 * std::abs(change) / widest);
  return std::string("<span class=\"bar\" aria-hidden=\"true\"><i class=\"") +
         (change < 0.0 ? "down" : "up") + "\" style=\"width:" + width + "%\"></i></span>";
}

const char* verdict(const ReportResult& row) {
  if (!std::isfinite(row.relative_change)) return "none";
  if (row.better == Better::kNeither || std::abs(row.relative_change) < kNegligible) return "even";
  return (row.relative_change < 0.0) == (row.better == Better::kLower) ? "better" : "worse";
}

std::string change_html(const ReportResult& row, double widest) {
  return std::string("<td class=\"change ") + verdict(row) + "\">" +
         bar_html(row.relative_change, widest) + displayed(format_change(row.relative_change)) +
         "</td>";
}

std::string result_row_html(const ReportResult& row, bool with_change, double widest) {
  std::string html = "<tr><th scope=\"row\" data-unit=\"" + escaped(row.unit) + "\">" +
                     escaped(row.quantity) + "</th><td class=\"unit\">" + escaped(row.unit) +
                     "</td>";
  for (const double value : row.values) {
    html += "<td>" + displayed(format_value(value, row.decimals)) + "</td>";
  }
  if (with_change) html += change_html(row, widest);
  return html + "</tr>\n";
}

std::string results_html(const HtmlReport& report) {
  std::string html =
      "<div class=\"table-wrap\"><table>\n<thead><tr><th scope=\"col\">Quantity</th>"
      "<th scope=\"col\" class=\"unit\">Unit</th>";
  for (std::size_t run = 0; run < report.runs.size(); ++run) {
    html += "<th scope=\"col\"><span class=\"swatch\" style=\"border-color:var(--run-" +
            std::to_string(run % kRunColours) + ")\"></span>" + escaped(report.runs[run]) + "</th>";
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
  std::string html =
      "<section aria-labelledby=\"notes-heading\"><h2 id=\"notes-heading\">Notes</h2>\n"
      "<ul class=\"notes\">\n";
  for (const std::string& note : notes) html += "<li>" + escaped(note) + "</li>\n";
  return html + "</ul></section>";
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

// One pass over the template: what was put in is not looked at again.
std::string filled(std::string_view page,
                   const std::map<std::string, std::string, std::less<>>& parts) {
  constexpr std::string_view kOpen = "<!--lac:", kClose = "-->";
  std::string html;
  for (std::size_t at = page.find(kOpen); at != std::string_view::npos; at = page.find(kOpen)) {
    const std::size_t end = page.find(kClose, at);
    html += page.substr(0, at);
    html += parts.at(std::string(page.substr(at + kOpen.size(), end - at - kOpen.size())));
    page.remove_prefix(end + kClose.size());
  }
  return html.append(page);
}

}  // namespace

std::string html_report(const HtmlReport& report) {
  validate(report);
  return filled(kReportPage, {{"title", escaped(report.title)},
                              {"metadata", metadata_html(report)},
                              {"results", results_html(report)},
                              {"notes", notes_html(report)},
                              {"data", report_json(report)}});
}

void write_html_report(const std::filesystem::path& path, const HtmlReport& report) {
  PartFile file(path);
  const std::string page = html_report(report);
  file.write(page.data(), page.size());
  file.commit();
}

}  // namespace lac::sim
