// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign_report/campaign_summary.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

constexpr std::size_t kMostListed = 6;  // values of a parameter; more are counted

std::string joined(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + text;
  return list;
}

/// "12, 14, 16"; of many the first, the last and how many.
std::string values_text(std::vector<std::string> values) {
  const bool numbers =
      std::ranges::all_of(values, [](const std::string& v) { return number_in(v).has_value(); });
  if (numbers) std::ranges::sort(values, {}, [](const std::string& v) { return *number_in(v); });
  if (values.size() <= kMostListed) return joined(values);
  return values.front() + " \u2026 " + values.back() + " (" + std::to_string(values.size()) +
         " values)";
}

/// "252 cases: 250 done, 2 failed"; a table without a status has rows.
std::string cases_text(const ResultRows& rows) {
  const std::size_t status = rows.column("status"), name = rows.column("case");
  const std::string total = std::to_string(rows.cells.size());
  if (status == ResultRows::kNone) return total + " runs";
  std::map<std::string, std::set<std::string>> cases;  // by status
  for (std::size_t i = 0; i < rows.cells.size(); ++i) {
    const auto& row = rows.cells[i];
    cases[row[status]].insert(name == ResultRows::kNone ? std::to_string(i) : row[name]);
  }
  std::size_t all = 0;
  std::vector<std::string> parts;
  for (const auto& [word, names] : cases) {
    all += names.size();
    parts.push_back(std::to_string(names.size()) + " " + word);
  }
  return std::to_string(all) + ": " + joined(parts);
}

std::string controllers_text(const CampaignReport& report) {
  std::vector<std::string> texts;
  for (const ReportedController& c : report.controllers)
    texts.push_back(c.name + " (" + std::to_string(c.runs.runs.size()) + " runs)");
  return joined(texts);
}

std::string loads_text(const CampaignReport& report) {
  const auto text_of = [](const ReportedController& c) { return del_text(c.runs); };
  const std::string first = text_of(report.controllers.front());
  const auto same = [&](const ReportedController& c) { return text_of(c) == first; };
  if (std::ranges::all_of(report.controllers, same)) return first;
  std::vector<std::string> texts;
  for (const ReportedController& c : report.controllers)
    texts.push_back(c.name + ": " + text_of(c));
  return joined(texts);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> campaign_summary(const CampaignReport& report) {
  std::vector<std::pair<std::string, std::string>> lines{{"Cases", cases_text(report.rows)},
                                                         {"Controllers", controllers_text(report)}};
  for (const std::size_t column : report.varied)
    lines.emplace_back(report.rows.columns[column], values_text(values_in(report.rows, column)));
  lines.emplace_back("Loads (_del4, _del10 \u2026)", loads_text(report));
  lines.emplace_back("Intervals", percent_text(report.confidence, 0) +
                                      " of the mean of paired differences, Student");
  lines.emplace_back("Winds of a life", "Weibull, scale " + format_value(report.wind.scale_mps, 2) +
                                            " m/s, shape " + format_value(report.wind.shape, 2));
  return lines;
}

std::vector<std::pair<std::string, std::string>> fixed_parameters(const CampaignReport& report) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (std::size_t c = 0; c < report.rows.columns.size(); ++c) {
    const std::string& name = report.rows.columns[c];
    if (is_bookkeeping(name) || !unit_in(name).empty()) continue;
    const std::vector<std::string> values = values_in(report.rows, c);
    if (values.size() == 1) lines.emplace_back(name, values.front());
  }
  return lines;
}

std::vector<CaseNotDone> cases_not_done(const CampaignReport& report) {
  std::vector<CaseNotDone> cases;
  const ResultRows& rows = report.rows;
  const auto text = [&](const std::vector<std::string>& row, const char* column) {
    const std::size_t at = rows.column(column);
    return at == ResultRows::kNone ? std::string() : row[at];
  };
  for (const auto& row : rows.cells) {
    const std::string status = text(row, "status");
    if (!status.empty() && status != "done")
      cases.push_back({text(row, "case"), status, text(row, "reason")});
  }
  return cases;
}

}  // namespace lac::sim
