// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign_report/campaign_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim_harness/comparison/mean_wind.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostClasses = 8;     // of a parameter that gets views of its own
constexpr std::size_t kFewQuantities = 12;  // in the tables, if none of the usual is there
constexpr std::size_t kMostListed = 20;     // names in a message
constexpr const char* kSeedColumn = "seed";

std::string inputs_of(const CampaignReportOptions& options) {
  std::string text;
  for (const fs::path& input : options.inputs) text += (text.empty() ? "" : ", ") + input.string();
  return text;
}

/// "a, b, c", of many the first and how many more.
std::string listed(const std::vector<std::string>& names) {
  if (names.empty()) return "none";
  std::string text;
  const std::size_t count = std::min(names.size(), kMostListed);
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + names[i];
  if (count < names.size()) text += " and " + std::to_string(names.size() - count) + " more";
  return text;
}

/// Figures of every controller that are values of a quantity, not times of extremes.
std::vector<std::string> common_quantities(const CampaignReportOptions& options,
                                           const std::vector<ReportedController>& controllers) {
  std::vector<std::string> names;
  for (const std::string& figure : controllers.front().runs.figures) {
    const std::string name(without_unit(figure));
    const auto has = [&](const ReportedController& c) {
      return std::ranges::any_of(c.runs.figures,
                                 [&](const std::string& f) { return without_unit(f) == name; });
    };
    if (!name.ends_with("_time") && std::ranges::all_of(controllers, has)) names.push_back(name);
  }
  if (!names.empty()) return names;
  std::string there;
  for (const ReportedController& c : controllers)
    there += "; " + c.name + " has: " + listed(c.runs.figures);
  throw Error(inputs_of(options) +
              ": no figure is common to all controllers, expected columns with a unit, 'x [kN]'" +
              there);
}

std::vector<std::string> shown_quantities(const CampaignReportOptions& options,
                                          const CampaignReport& report) {
  for (const std::string& name : options.quantities)
    if (std::ranges::find(report.quantities, name) == report.quantities.end())
      throw Error(inputs_of(options) + ": no quantity '" + name + "'" +
                  did_you_mean(name, report.quantities) +
                  "; common to all controllers are: " + listed(report.quantities));
  if (!options.quantities.empty()) return options.quantities;
  std::vector<const RunTable*> tables;
  for (const ReportedController& c : report.controllers) tables.push_back(&c.runs);
  std::vector<std::string> shown = usual_among(tables);
  if (!shown.empty()) return shown;
  shown = report.quantities;
  shown.resize(std::min(shown.size(), kFewQuantities));
  return shown;
}

/// Tables, their controllers, rows: read once, cut as often as there are views.
class Reader {
 public:
  explicit Reader(const CampaignReportOptions& options) : options_(options) {
    for (const fs::path& input : options.inputs) tables_.emplace_back(result_table_of(input));
    if (tables_.empty()) throw Error("report: expected a folder of a campaign or a table");
    rows_ = result_rows(tables_, options.runs);
  }

  const ResultRows& rows() const { return rows_; }

  /// Every controller's runs that meet these conditions too; without runs: none of them do.
  std::vector<ReportedController> controllers(const std::string& condition) const {
    RunTableOptions runs = options_.runs;
    if (!condition.empty()) runs.where.push_back(condition);
    std::vector<ReportedController> found;
    for (std::size_t t = 0; t < tables_.size(); ++t) {
      std::vector<std::string> names = controllers_in(tables_[t], runs);
      if (names.empty()) names.emplace_back();
      for (const std::string& name : names) found.push_back(controller(t, name, runs));
    }
    return found;
  }

  std::string wind_column() const {
    return wind_column_of(tables_.front().file().string(), options_.runs.wind_column,
                          [&](const char* name) { return tables_.front().find(name).has_value(); });
  }

  std::string title() const {
    return options_.title.empty() ? table_name(tables_.front().file()) : options_.title;
  }

 private:
  ReportedController controller(std::size_t table, const std::string& name,
                                const RunTableOptions& runs) const {
    ReportedController c{name, runs_of_table(tables_[table], name, runs), {}};
    const std::string of_table = table_name(tables_[table].file());
    if (name.empty()) c.name = of_table;
    if (!name.empty() && tables_.size() > 1) c.name = of_table + " " + name;
    c.runs.name = c.name;
    for (const RunTable::Run& run : c.runs.runs)
      c.rows.push_back(rows_.row_of_table[table][run.row]);
    return c;
  }

  const CampaignReportOptions& options_;
  std::vector<CsvTable> tables_;
  ResultRows rows_;
};

void baseline_first(const CampaignReportOptions& options,
                    std::vector<ReportedController>& controllers) {
  const std::string& baseline = options.baseline;
  if (baseline.empty()) return;
  const auto found = std::ranges::find(controllers, baseline, &ReportedController::name);
  if (found == controllers.end()) {
    std::vector<std::string> names;
    for (const ReportedController& c : controllers) names.push_back(c.name);
    throw Error(inputs_of(options) + ": no controller '" + baseline + "'" +
                did_you_mean(baseline, names) + "; there are: " + listed(names));
  }
  std::rotate(controllers.begin(), found, found + 1);
}

/// Those of the second that have the names of the first, in their order.
std::vector<ReportedController> in_order_of(const std::vector<ReportedController>& order,
                                            const std::vector<ReportedController>& controllers) {
  std::vector<ReportedController> sorted;
  for (const ReportedController& wanted : order)
    sorted.push_back(*std::ranges::find(controllers, wanted.name, &ReportedController::name));
  return sorted;
}

ReportedView view_of(const std::vector<ReportedController>& controllers,
                     const CampaignReport& report, std::vector<std::string>* problems) {
  ReportedView view;
  for (const ReportedController& c : controllers)
    view.lives.push_back(c.runs.runs.empty() ? LifeTable{}
                                             : life_table(c.runs, report.quantities, report.wind));
  for (std::size_t b = 1; b < controllers.size(); ++b) {
    try {
      view.comparisons.push_back(
          {0, b,
           compare_runs(controllers[0].runs, controllers[b].runs,
                        {report.quantities, report.confidence, report.wind})});
    } catch (const Error& e) {  // no pair: the page says so and shows the rest
      if (problems != nullptr) problems->push_back(std::string("not compared: ") + e.what());
    }
  }
  return view;
}

/// A class of winds: few values, not the mean speed and not the seed.
bool is_class(const CampaignReport& report, std::size_t column, const std::string& wind_column) {
  const std::string& name = report.rows.columns[column];
  if (name == wind_column || name == kSeedColumn || name.find('=') != std::string::npos)
    return false;
  const std::size_t count = values_in(report.rows, column).size();
  return count > 1 && count <= kMostClasses;
}

void add_class_views(const Reader& reader, const CampaignReportOptions& options,
                     CampaignReport& report) {
  const std::string wind_column = reader.wind_column();
  for (const std::size_t column : report.varied) {
    if (options.inputs.size() > 1 || !is_class(report, column, wind_column)) continue;
    for (const std::string& value : values_in(report.rows, column)) {
      const std::string& name = report.rows.columns[column];
      const auto controllers =
          in_order_of(report.controllers, reader.controllers(name + "=" + value));
      const auto flew = [](const ReportedController& c) { return !c.runs.runs.empty(); };
      // A value that not all controllers have flown is no class of winds.
      if (!std::ranges::all_of(controllers, flew)) continue;
      report.views.push_back(view_of(controllers, report, nullptr));
      report.views.back().name = name + " = " + value;
      report.views.back().column = column;
      report.views.back().value = value;
    }
  }
}

}  // namespace

CampaignReport campaign_report(const CampaignReportOptions& options) {
  const Reader reader(options);
  CampaignReport report;
  report.title = reader.title();
  report.rows = reader.rows();
  report.wind = options.wind;
  report.confidence = options.confidence;
  report.varied = varied_columns(report.rows, options.runs);
  report.controllers = reader.controllers({});
  std::erase_if(report.controllers,
                [](const ReportedController& c) { return c.runs.runs.empty(); });
  if (report.controllers.empty())
    throw Error(options.inputs.front().string() + ": no run in it is done");
  baseline_first(options, report.controllers);
  report.quantities = common_quantities(options, report.controllers);
  report.shown = shown_quantities(options, report);
  report.views.push_back(view_of(report.controllers, report, &report.notes));
  report.views.back().name = "all runs";
  add_class_views(reader, options, report);
  return report;
}

}  // namespace lac::sim
