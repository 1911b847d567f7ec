// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim_harness/campaign_report/campaign_page.hpp"
#include "sim_harness/output/page_parts.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

constexpr int kDigits = 6;

std::string number(double value) {
  return json_number(value, kDigits);
}

std::string index(std::size_t i) {
  return i == ResultRows::kNone ? "null" : std::to_string(i);
}

bool is_figure(const std::string& column) {
  return !unit_in(column).empty();
}

std::string row_json(const ResultRows& rows, const std::vector<std::string>& row) {
  std::string json = "[";
  for (std::size_t c = 0; c < row.size(); ++c) {
    if (c > 0) json += ',';
    const auto value = is_figure(rows.columns[c]) ? number_in(row[c]) : std::nullopt;
    json += value ? number(*value) : json_text(row[c]);
  }
  return json + "]";
}

std::string quantity_json(const CampaignReport& report, std::size_t i) {
  const std::string& name = report.quantities[i];
  const RunTable& runs = report.controllers.front().runs;
  const std::string& figure = runs.figures[figure_index(runs, name)];
  const bool shown = std::ranges::find(report.shown, name) != report.shown.end();
  return "{\"name\":" + json_text(name) + ",\"unit\":" + json_text(unit_in(figure)) +
         ",\"column\":" + index(report.rows.column(figure)) +
         ",\"shown\":" + (shown ? "true" : "false") + "}";
}

std::string change_json(const std::optional<Change>& change) {
  if (!change) return "null";
  return "[" + std::to_string(change->pairs) + "," + number(change->a) + "," + number(change->b) +
         "," + number(change->relative) + "," + number(change->relative_low) + "," +
         number(change->relative_high) + "," + (change->significant ? "1" : "0") + "]";
}

std::string life_json(const LifeTable& life) {
  return "{\"speeds\":" + json_array(life.speeds_mps, number) + ",\"values\":" +
         json_array(life.quantities,
                    [](const LifeQuantity& q) {
                      std::vector<double> values = q.at_speed;
                      values.push_back(q.life.value_or(std::nan("")));
                      return json_array(values, number);
                    }) +
         "}";
}

std::string versus_json(const CampaignReport& report, const ReportedView& view,
                        const ReportedView::Versus& versus) {
  const Comparison& c = versus.comparison;
  const auto pair = [&](const RunPair& p) {
    const ReportedController &a = report.controllers[versus.a], &b = report.controllers[versus.b];
    return "[" + index(a.rows[p.a]) + "," + index(b.rows[p.b]) + "," +
           number(a.runs.runs[p.a].wind_mps) + "]";
  };
  const auto changes = [](const QuantityChange& q) {
    std::vector<std::optional<Change>> all = q.at_speed;
    all.push_back(q.life);
    return json_array(all, change_json);
  };
  // Pairs of a class are those of all runs that are in it; their places are of all runs.
  const bool all_runs = view.column == ResultRows::kNone;
  return "{\"a\":" + index(versus.a) + ",\"b\":" + index(versus.b) +
         ",\"speeds\":" + json_array(c.speeds_mps, number) +
         ",\"pairs\":" + (all_runs ? json_array(c.runs, pair) : "[]") +
         ",\"changes\":" + json_array(c.quantities, changes) + "}";
}

std::string view_json(const CampaignReport& report, const ReportedView& view) {
  const auto versus = [&](const auto& v) { return versus_json(report, view, v); };
  return "{\"name\":" + json_text(view.name) + ",\"column\":" + index(view.column) +
         ",\"value\":" + json_text(view.value) + ",\"lives\":" + json_array(view.lives, life_json) +
         ",\"comparisons\":" + json_array(view.comparisons, versus) + "}";
}

/// [row, controller, speed] of every run.
std::string runs_json(const CampaignReport& report) {
  std::vector<std::string> runs;
  for (std::size_t c = 0; c < report.controllers.size(); ++c) {
    const ReportedController& controller = report.controllers[c];
    for (std::size_t i = 0; i < controller.rows.size(); ++i)
      runs.push_back("[" + index(controller.rows[i]) + "," + index(c) + "," +
                     number(controller.runs.runs[i].wind_mps) + "]");
  }
  return json_array(runs, [](const std::string& run) { return run; });
}

}  // namespace

std::string campaign_data_json(const CampaignReport& report) {
  std::vector<std::size_t> quantities(report.quantities.size());
  for (std::size_t i = 0; i < quantities.size(); ++i) quantities[i] = i;
  const auto column = [](const std::string& name) {
    return "{\"name\":" + json_text(name) + ",\"figure\":" + (is_figure(name) ? "true" : "false") +
           "}";
  };
  return "{\"controllers\":" +
         json_array(report.controllers, [](const auto& c) { return json_text(c.name); }) +
         ",\"columns\":" + json_array(report.rows.columns, column) +
         ",\"varied\":" + json_array(report.varied, index) + ",\"quantities\":" +
         json_array(quantities, [&](std::size_t i) { return quantity_json(report, i); }) +
         ",\"rows\":" +
         json_array(report.rows.cells,
                    [&](const auto& row) { return row_json(report.rows, row); }) +
         ",\"runs\":" + runs_json(report) + ",\"views\":" +
         json_array(report.views, [&](const auto& view) { return view_json(report, view); }) +
         "}\n";
}

}  // namespace lac::sim
