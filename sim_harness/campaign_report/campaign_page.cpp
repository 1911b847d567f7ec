// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign_report/campaign_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim_harness/campaign_report/campaign_summary.hpp"
#include "sim_harness/comparison/comparison_text.hpp"
#include "sim_harness/output/html_report.hpp"
#include "sim_harness/output/page_parts.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {

extern const char kCampaignPage[];  // campaign_page.html with style and scripts, made by the build

namespace {

constexpr int kDigits = 5;
constexpr double kKilo = 1e-3;
constexpr double kNegligible = 0.001;  // has no colour, be it significant

std::string cell(const std::string& text) {
  return "<td>" + text + "</td>";
}

std::string value_cell(double value) {
  return cell(displayed_number(format_significant(value, kDigits)));
}

std::string heading(const std::string& text) {
  return "<th scope=\"col\">" + html_text(text) + "</th>";
}

std::string row_heading(const std::string& name, const std::string& unit) {
  return "<th scope=\"row\" data-unit=\"" + html_text(unit) + "\">" + html_text(name) + "</th>";
}

std::string table(const std::string& label, const std::string& head, const std::string& body) {
  return "<div class=\"table-wrap\"><table class=\"sortable\" aria-label=\"" + html_text(label) +
         "\">\n<thead><tr>" + head + "</tr></thead>\n<tbody>\n" + body + "</tbody></table></div>\n";
}

std::string speed_text(double speed_mps) {
  char text[32];
  std::snprintf(text, sizeof text, "%g m/s", speed_mps);
  return text;
}

/// Is more of it better, or less? Means but of power tell nothing.
Better better(const std::string& quantity, const std::string& unit) {
  const bool power = unit == "kW" || unit == "MW" || unit == "W" || unit == "kWh";
  if (quantity.ends_with("_mean") || quantity.ends_with("_energy"))
    return power ? Better::kHigher : Better::kNeither;
  return quantity.ends_with("_min") ? Better::kNeither : Better::kLower;
}

const char* colour(const QuantityChange& q, const std::optional<Change>& change) {
  const Better wanted = better(q.name, q.unit);
  const bool matters = change && change->significant && std::abs(change->relative) >= kNegligible;
  if (!matters || wanted == Better::kNeither) return "even";
  return (change->relative < 0.0) == (wanted == Better::kLower) ? "better" : "worse";
}

/// With true minus signs; a hyphen between words stays.
std::string with_minus(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at + 1))
    if (at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9')
      text.replace(at, 1, "\u2212");
  return text;
}

std::string change_cell(const QuantityChange& q, const std::optional<Change>& change,
                        const std::string& before = {}) {
  return std::string("<td class=\"change ") + colour(q, change) + "\">" + before +
         with_minus(html_text(change_text(change))) + "</td>";
}

std::string life_row(const QuantityChange& q, double widest) {
  const Change& life = *q.life;
  const std::string interval =
      std::isfinite(life.relative_low)
          ? format_change(life.relative_low) + " \u2026 " + format_change(life.relative_high)
          : "n/a";
  std::string html = "<tr>" + row_heading(q.name, q.unit) + "<td class=\"unit\">" +
                     html_text(q.unit) + "</td>" + value_cell(life.a) + value_cell(life.b) +
                     change_cell(q, life, bar_html(life.relative, widest)) +
                     cell(with_minus(interval)) + cell(html_text(life.verdict)) + "</tr>\n";
  if (!q.annual_energy_a_kWh) return html;
  return html + "<tr>" + row_heading("energy of a year, from " + q.name, "MWh") +
         "<td class=\"unit\">MWh</td>" + value_cell(kKilo * *q.annual_energy_a_kWh) +
         value_cell(kKilo * *q.annual_energy_b_kWh) + cell("") + cell("") + cell("") + "</tr>\n";
}

std::string over_a_life(const Comparison& c) {
  double widest = 0.0;
  for (const QuantityChange& q : c.quantities)
    if (q.life && std::isfinite(q.life->relative))
      widest = std::max(widest, std::abs(q.life->relative));
  std::string body;
  for (const QuantityChange& q : c.quantities)
    if (q.life) body += life_row(q, widest);
  if (body.empty()) return "<p class=\"hint\">No quantity is there at every wind speed.</p>";
  return table("Change over a life",
               heading("Quantity") + "<th scope=\"col\" class=\"unit\">Unit</th>" +
                   heading("A: " + c.a) + heading("B: " + c.b) + heading("Change") +
                   heading("Interval") + heading("Significance"),
               body);
}

std::string by_speed(const Comparison& c) {
  std::string head = heading("Quantity");
  for (std::size_t i = 0; i < c.speeds_mps.size(); ++i)
    head += heading(speed_text(c.speeds_mps[i]) + ", " + std::to_string(c.pairs[i]) +
                    (c.pairs[i] == 1 ? " pair" : " pairs"));
  std::string body;
  for (const QuantityChange& q : c.quantities) {
    body += "<tr>" + row_heading(q.name, q.unit);
    for (const std::optional<Change>& change : q.at_speed) body += change_cell(q, change);
    body += "</tr>\n";
  }
  return table("Change by wind speed", head, body);
}

/// The same with these quantities alone, so that what is counted in the notes is what is shown.
Comparison shown_part(const Comparison& all, const std::vector<std::string>& shown) {
  Comparison part = all;
  part.quantities.clear();
  for (const std::string& name : shown)
    part.quantities.push_back(*std::ranges::find(all.quantities, name, &QuantityChange::name));
  return part;
}

std::string comparisons_html(const CampaignReport& report) {
  std::string html;
  for (std::size_t v = 0; v < report.views.size(); ++v) {
    for (const ReportedView::Versus& versus : report.views[v].comparisons) {
      const Comparison c = shown_part(versus.comparison, report.shown);
      html += "<article class=\"comparison\" data-view=\"" + std::to_string(v) + "\" data-b=\"" +
              std::to_string(versus.b) + "\">\n<h3>From A = " + html_text(c.a) +
              " to B = " + html_text(c.b) + ": " + html_text(report.views[v].name) +
              "</h3>\n<h4>Over a life</h4>\n" + over_a_life(c) + "<h4>By wind speed</h4>\n" +
              by_speed(c) + list_html(comparison_notes(c, report.wind)) + "</article>\n";
    }
  }
  return html;
}

std::string life_html(const LifeTable& life, const std::vector<std::string>& shown) {
  std::string head = heading("Quantity") + "<th scope=\"col\" class=\"unit\">Unit</th>";
  for (std::size_t i = 0; i < life.speeds_mps.size(); ++i)
    head += heading(speed_text(life.speeds_mps[i]) + ", " + std::to_string(life.runs[i]) +
                    (life.runs[i] == 1 ? " run" : " runs"));
  std::string body;
  for (const std::string& name : shown) {
    const auto q = std::ranges::find(life.quantities, name, &LifeQuantity::name);
    body += "<tr>" + row_heading(q->name, q->unit) + "<td class=\"unit\">" + html_text(q->unit) +
            "</td>";
    for (const double value : q->at_speed) body += value_cell(value);
    body += (q->life ? value_cell(*q->life) : cell("-")) + "</tr>\n";
  }
  return table(life.name + " by wind speed", head + heading("life"), body);
}

std::string lives_html(const CampaignReport& report) {
  const ReportedView& all = report.views.front();
  std::string html = all.comparisons.empty() ? "<details open>" : "<details>";
  html += "<summary>Each controller by wind speed and over a life</summary>\n";
  for (const LifeTable& life : all.lives)
    html += "<h3>" + html_text(life.name) + "</h3>\n" + life_html(life, report.shown);
  return html +
         "<p class=\"hint\">Loads by their mean damage, extremes the largest and least, others "
         "means over the runs; over a life weighted with the time at each speed.</p></details>\n";
}

std::string not_done_html(const CampaignReport& report) {
  std::string body;
  for (const CaseNotDone& c : cases_not_done(report))
    body += "<tr><th scope=\"row\">" + html_text(c.name) + "</th>" + cell(html_text(c.status)) +
            "<td class=\"words\">" + html_text(c.reason) + "</td></tr>\n";
  if (body.empty()) return {};
  return "<section aria-labelledby=\"not-done-heading\"><h2 id=\"not-done-heading\">Not "
         "done</h2>\n" +
         table("Cases that are not done", heading("Case") + heading("Status") + heading("Reason"),
               body) +
         "</section>\n";
}

std::string fixed_html(const CampaignReport& report) {
  const auto fixed = fixed_parameters(report);
  if (fixed.empty()) return {};
  return "<details><summary>The same in all cases</summary>\n" + metadata_html(fixed) +
         "</details>\n";
}

std::string notes_html(const CampaignReport& report) {
  if (report.notes.empty()) return {};
  return "<section><h2>Notes</h2>\n" + list_html(report.notes) + "</section>\n";
}

}  // namespace

std::filesystem::path page_beside(const std::filesystem::path& folder_or_table) {
  const std::filesystem::path table = result_table_of(folder_or_table);
  const std::string stem = table.filename() == "results.csv" ? "report" : table.stem().string();
  return table.parent_path() / (stem + ".html");
}

std::string campaign_page(const CampaignReport& report) {
  return filled_page(kCampaignPage, {{"title", html_text(report.title)},
                                     {"metadata", metadata_html(campaign_summary(report))},
                                     {"fixed", fixed_html(report)},
                                     {"comparisons", comparisons_html(report)},
                                     {"lives", lives_html(report)},
                                     {"not-done", not_done_html(report)},
                                     {"notes", notes_html(report)},
                                     {"data", campaign_data_json(report)}});
}

}  // namespace lac::sim
