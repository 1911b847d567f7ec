// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/marked_case.hpp"

#include <new>

#include "core/error.hpp"
#include "sim_harness/analysis/channel_figures.hpp"
#include "sim_harness/run/interruption.hpp"
#include "sim_harness/tables/csv_table.hpp"

namespace lac::sim {
namespace {

void fly(const MarkedCase& order, const CaseWind* shared, MarkerWriter& marker, std::ostream& out) {
  Case c = load_case(order.case_file, order.overrides);
  c.outputs.folder = order.folder;
  const CaseResult result = shared ? fly_case(c, *shared, out) : run_case(c, out);
  marker.done(figures_of(c, result));
}

}  // namespace

CaseFigures figures_of(const Case& c, const CaseResult& result) {
  FigureOptions options;
  options.from_s = c.time.run_in_s;
  CaseFigures figures;
  for (const FlownController& flown : result.flights) {
    figures.controllers.push_back(flown.name);
    figures.columns = {kDelReferenceColumn, kDelRainflowColumn};
    std::vector<std::string> row{word_of(options.reference), word_of(options.counting)};
    for (const NamedFigure& f : named_figures(channel_figures(flown.recording, options), options)) {
      figures.columns.push_back(f.header());
      row.push_back(csv_number(f.value));
    }
    figures.rows.push_back(std::move(row));
  }
  return figures;
}

void fly_marked(const MarkedCase& order, const std::string& fingerprint, const CaseWind* shared,
                std::ostream& out) {
  MarkerWriter marker(order.folder, fingerprint);
  try {
    fly(order, shared, marker, out);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::bad_alloc&) {
    marker.failed("not enough memory");
    throw;
  } catch (const std::exception& e) {
    marker.failed(e.what());
    throw;
  }
}

}  // namespace lac::sim
