// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/compare_command.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim_harness/cli/written_table.hpp"
#include "sim_harness/comparison/comparison_text.hpp"
#include "sim_harness/comparison/life_table.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr const char* kNamesOfTwo = "--baseline and --against name them";
constexpr const char* kNameOfOne = "--controller names it";

std::string list_of(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// The controller of this name; without a name the one at this place of the list.
std::string controller_of(const CsvTable& table, const std::string& wanted, std::size_t place,
                          std::size_t expected, const RunTableOptions& o,
                          const std::string& options_that_name) {
  const std::vector<std::string> there = controllers_in(table, o);
  const std::string where = table.file().string() + ": column '" + o.controller_column + "'";
  if (!wanted.empty()) {
    if (std::ranges::find(there, wanted) != there.end()) return wanted;
    throw Error(where + " has no '" + wanted + "'" + did_you_mean(wanted, there) +
                "; there are: " + list_of(there));
  }
  if (there.size() == expected) return there[place];
  if (there.empty() && expected == 1) return {};
  throw Error(where + " has " + std::to_string(there.size()) + " controllers (" + list_of(there) +
              "), expected " + std::to_string(expected) + "; " + options_that_name);
}

RunTable runs_of(const fs::path& input, const std::string& controller, const FigureOptions& figures,
                 const RunTableOptions& o, const std::string& options_that_name) {
  if (fs::is_directory(input)) return runs_of_folder(input, figures, o);
  const CsvTable table(input);
  const std::string name = controller_of(table, controller, 0, 1, o, options_that_name);
  RunTable runs = runs_of_table(table, name, o);
  runs.name = name.empty() ? input.stem().string() : input.stem().string() + " " + name;
  return runs;
}

std::pair<RunTable, RunTable> both(const CompareOptions& o) {
  if (o.inputs.size() == 2)
    return {runs_of(o.inputs[0], o.baseline, o.figures, o.runs, kNamesOfTwo),
            runs_of(o.inputs[1], o.against, o.figures, o.runs, kNamesOfTwo)};
  if (o.inputs.size() != 1 || fs::is_directory(o.inputs[0]))
    throw Error(
        "compare: expected one table (.csv) with two controllers, two tables or two folders");
  const CsvTable table(o.inputs[0]);
  const std::string a = controller_of(table, o.baseline, 0, 2, o.runs, kNamesOfTwo);
  const std::string b = controller_of(table, o.against, 1, 2, o.runs, kNamesOfTwo);
  if (a == b) throw Error("compare: '" + a + "' against itself, expected two controllers");
  return {runs_of_table(table, a, o.runs), runs_of_table(table, b, o.runs)};
}

}  // namespace

void compare_command(const CompareOptions& options, std::ostream& out) {
  const auto [a, b] = both(options);
  const Comparison comparison = compare_runs(a, b, options.comparison);
  out << comparison_text(comparison, options.comparison.wind);
  write_table(options.csv, comparison_csv(comparison), out);
}

void life_command(const LifeOptions& o, std::ostream& out) {
  const RunTable runs = runs_of(o.input, o.controller, o.figures, o.runs, kNameOfOne);
  const auto quantities = o.quantities.empty() ? usual_quantities({&runs}) : o.quantities;
  out << life_text(life_table(runs, quantities, o.wind), o.wind);
  if (runs.left_out > 0) out << "not done and left out: " << runs.left_out << " rows\n";
}

}  // namespace lac::sim
