// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/tuning_report.hpp"

#include <algorithm>
#include <sstream>

#include "core/input_file.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/run/flight.hpp"
#include "sim_harness/tables/csv_table.hpp"

namespace lac::sim {
namespace {

using Kind = TuningTarget::Kind;

std::string name_of(const TuningTarget& t) {
  return t.where.empty() ? t.figure : t.figure + " (" + t.where + ")";
}

std::string demand_of(const TuningTarget& t) {
  if (t.kind == Kind::kMinimise) return "minimise " + name_of(t);
  if (t.kind == Kind::kMaximise) return "maximise " + name_of(t);
  return name_of(t) + (t.kind == Kind::kAtLeast ? " at least " : " at most ") +
         format_change(t.limit);
}

std::vector<std::string> header(const TuningResult& r) {
  std::vector<std::string> names;
  for (const TuningParameter& p : r.tuning.parameters) names.push_back(p.key);
  for (const TuningTarget& t : r.tuning.targets) names.push_back(name_of(t));
  return names;
}

std::vector<std::string> row(const TuningResult& r, const Evaluation& e) {
  std::vector<std::string> cells;
  for (const double v : e.values) cells.push_back(shortest(v));
  for (std::size_t i = 0; i < r.tuning.targets.size(); ++i)
    cells.push_back(e.problem.empty() ? format_change(e.changes[i]) : "n/a");
  return cells;
}

std::string note_of(const Evaluation& e, bool on_front, bool is_best) {
  if (!e.problem.empty()) return "failed";
  std::string note = e.meets_conditions() ? "" : "misses a condition";
  if (on_front) note += note.empty() ? "Pareto" : ", Pareto";
  if (is_best) note += note.empty() ? "best" : ", best";
  return note;
}

std::string all_evaluations(const TuningResult& r, const std::vector<bool>& front,
                            std::size_t best) {
  std::vector<std::string> names = header(r);
  names.insert(names.begin(), "no.");
  names.push_back("note");
  TextTable table(names);
  for (std::size_t i = 0; i < r.evaluations.size(); ++i) {
    std::vector<std::string> cells = row(r, r.evaluations[i]);
    cells.insert(cells.begin(), std::to_string(i + 1));
    cells.push_back(note_of(r.evaluations[i], front[i], i == best));
    table.add_row(cells);
  }
  return table.text();
}

/// Why evaluations failed, under the table.
std::string problems(const TuningResult& r) {
  std::string text;
  for (std::size_t i = 0; i < r.evaluations.size(); ++i) {
    const std::string& problem = r.evaluations[i].problem;
    if (!problem.empty()) text += std::to_string(i + 1) + " failed: " + problem + "\n";
  }
  return text;
}

std::string front_table(const TuningResult& r, const std::vector<bool>& front) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < front.size(); ++i)
    if (front[i]) members.push_back(i);
  std::ranges::stable_sort(members, {}, [&](std::size_t i) {
    return r.evaluations[i].figures.front() * (r.tuning.targets.front().wants_less() ? 1.0 : -1.0);
  });
  TextTable table(header(r));
  for (const std::size_t i : members) table.add_row(row(r, r.evaluations[i]));
  return table.text();
}

std::string unit_of(const TuningTarget& t) {
  const std::string channel = t.figure.substr(0, t.figure.find('_'));
  const auto channels = flight_channels();
  const auto found = std::ranges::find(channels, channel, &TableChannel::name);
  return t.figure.ends_with("_energy") || found == channels.end() ? "" : " " + found->unit;
}

/// "TwrBsMyt_max (turbulence etm): 81120 -> 60630 kNm, -25.3 %".
std::string change_line(const TuningResult& r, std::size_t target, const Evaluation& e) {
  const TuningTarget& t = r.tuning.targets[target];
  return name_of(t) + ": " + format_significant(r.baseline[target], 5) + " -> " +
         format_significant(e.figures[target], 5) + unit_of(t) + ", " +
         format_change(e.changes[target]);
}

std::string settings_of(const TuningResult& r, const Evaluation& e) {
  std::string text;
  for (std::size_t i = 0; i < e.values.size(); ++i)
    text += (i ? ", " : "") + r.tuning.parameters[i].key + " " + shortest(e.values[i]);
  return text;
}

}  // namespace

std::string tuning_text(const TuningResult& r) {
  const std::vector<bool> front = pareto_front(r.evaluations, r.tuning.targets);
  const std::size_t best = best_of(r.evaluations, r.tuning.targets);
  std::ostringstream text;
  text << "lac tune " << r.tuning.file.filename().string() << ": " << r.tuning.controller
       << ", changes from " << r.tuning.baseline << ", " << r.tuning.cases.size()
       << " flights each\n";
  for (const TuningTarget& t : r.tuning.targets) text << "  " << demand_of(t) << '\n';
  text << '\n'
       << all_evaluations(r, front, best) << problems(r) << "\nPareto front\n"
       << front_table(r, front) << '\n';
  if (best == r.evaluations.size()) {
    text << "nothing could be flown\n";
    return text.str();
  }
  const Evaluation& e = r.evaluations[best];
  text << (e.meets_conditions() ? "best: " : "no parameters meet all conditions; nearest: ")
       << settings_of(r, e) << '\n';
  for (std::size_t i = 0; i < r.tuning.targets.size(); ++i)
    text << "  " << change_line(r, i, e) << '\n';
  return text.str();
}

std::string evaluations_csv(const TuningResult& r) {
  std::vector<std::string> names{"stage"};
  for (const TuningParameter& p : r.tuning.parameters) names.push_back(p.key);
  for (const TuningTarget& t : r.tuning.targets) {
    names.push_back(name_of(t));
    names.push_back(name_of(t) + " change");
  }
  for (const char* name : {"violation", "pareto", "problem"}) names.emplace_back(name);
  std::string text = csv_line(names);
  const std::vector<bool> front = pareto_front(r.evaluations, r.tuning.targets);
  for (std::size_t i = 0; i < r.evaluations.size(); ++i) {
    const Evaluation& e = r.evaluations[i];
    std::vector<std::string> cells{i < r.grid ? "grid" : "refinement"};
    for (const double v : e.values) cells.push_back(csv_number(v));
    for (std::size_t t = 0; t < r.tuning.targets.size(); ++t) {
      cells.push_back(e.problem.empty() ? csv_number(e.figures[t]) : "");
      cells.push_back(e.problem.empty() ? csv_number(e.changes[t]) : "");
    }
    cells.push_back(e.problem.empty() ? csv_number(e.violation) : "");
    cells.emplace_back(front[i] ? "1" : "0");
    cells.push_back(e.problem);
    text += csv_line(cells);
  }
  return text;
}

std::string origin_comment(const TuningResult& r, std::size_t best) {
  const Evaluation& e = r.evaluations[best];
  std::string text = "! lac tune " + r.tuning.file.filename().string() + ": " + settings_of(r, e) +
                     "; changes from " + r.tuning.baseline + ":\n";
  for (std::size_t i = 0; i < r.tuning.targets.size(); ++i)
    text += "!   " + change_line(r, i, e) + "\n";
  return text;
}

}  // namespace lac::sim
