// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/result_table.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/part_file.hpp"
#include "sim_harness/analysis/channel_figures.hpp"
#include "sim_harness/tables/csv_table.hpp"

namespace lac::sim {
namespace {

constexpr std::array<const char*, 6> kOwnColumns{
    "case", "status", "reason", "controller", kDelReferenceColumn, kDelRainflowColumn};

std::string last_word(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

/// Named ranges as they are; of keys the last word, unless something else is called so.
std::vector<std::string> range_columns(const Study& study) {
  std::vector<std::string> columns;
  for (const StudyRange& range : study.ranges) {
    const std::string word = range.named ? range.name : last_word(range.name);
    const auto same = std::ranges::count_if(study.ranges, [&](const StudyRange& r) {
      return (r.named ? r.name : last_word(r.name)) == word;
    });
    const bool own = std::ranges::find(kOwnColumns, word) != kOwnColumns.end();
    columns.push_back(same > 1 || own ? range.name : word);
  }
  return columns;
}

/// Keys that a study sets and that are not ranges by themselves, in the order of the file.
std::vector<std::string> other_keys(const Study& study) {
  std::vector<std::string> keys;
  const auto add = [&](const std::vector<StudySetting>& settings) {
    for (const StudySetting& s : settings)
      if (std::ranges::find(keys, s.key) == keys.end()) keys.push_back(s.key);
  };
  for (const StudyRange& range : study.ranges) {
    if (!range.named) continue;
    for (const StudyChoice& choice : range.choices) add(choice.settings);
  }
  add(study.settings);
  return keys;
}

std::string value_of(const Study& study, const StudyCase& c, const std::string& key) {
  const auto in = [&](const std::vector<StudySetting>& settings) -> const StudySetting* {
    const auto found = std::ranges::find(settings, key, &StudySetting::key);
    return found == settings.end() ? nullptr : &*found;
  };
  for (std::size_t r = 0; r < c.choices.size(); ++r)
    if (const StudySetting* s = in(study.ranges[r].choices[c.choices[r]].settings)) return s->value;
  const StudySetting* s = in(study.settings);
  return s == nullptr ? "" : s->value;
}

/// All cells of a case but controller and figures.
std::vector<std::string> parameter_cells(const Study& study, const StudyCase& c,
                                         const CaseMarker& marker,
                                         const std::vector<std::string>& keys) {
  std::string reason = marker.reason;
  std::ranges::replace(reason, '\n', ' ');
  std::vector<std::string> cells{c.name, word(marker.state), reason};
  for (std::size_t r = 0; r < c.choices.size(); ++r)
    cells.push_back(study.ranges[r].choices[c.choices[r]].name);
  for (const std::string& key : keys) cells.push_back(value_of(study, c, key));
  return cells;
}

std::vector<std::string> figure_columns(const std::vector<CaseMarker>& markers) {
  const auto done = std::ranges::find(markers, CaseState::kDone, &CaseMarker::state);
  return done == markers.end() ? std::vector<std::string>{} : done->figures.columns;
}

std::string rows_of(const CaseMarker& marker, const std::vector<std::string>& parameters,
                    std::size_t figures) {
  if (marker.state != CaseState::kDone) {
    std::vector<std::string> cells = parameters;
    cells.resize(parameters.size() + 1 + figures);
    return csv_line(cells);
  }
  std::string text;
  for (std::size_t i = 0; i < marker.figures.rows.size(); ++i) {
    std::vector<std::string> cells = parameters;
    cells.push_back(marker.figures.controllers[i]);
    cells.insert(cells.end(), marker.figures.rows[i].begin(), marker.figures.rows[i].end());
    text += csv_line(cells);
  }
  return text;
}

}  // namespace

void check_columns(const Study& study) {
  for (const StudyRange& range : study.ranges) {
    const bool own = std::ranges::find(kOwnColumns, range.name) != kOwnColumns.end();
    if (own)
      throw Error(study.file.string() + ":" + std::to_string(range.line) + ": ranges." +
                  range.name + ": the table of results has another column of this name; expected " +
                  "a different one");
  }
}

void write_result_table(const std::filesystem::path& file, const Study& study,
                        const std::vector<StudyCase>& cases,
                        const std::vector<CaseMarker>& markers) {
  const std::vector<std::string> keys = other_keys(study);
  const std::vector<std::string> figures = figure_columns(markers);
  std::vector<std::string> names{"case", "status", "reason"};
  for (const std::string& name : range_columns(study)) names.push_back(name);
  names.insert(names.end(), keys.begin(), keys.end());
  names.push_back("controller");
  names.insert(names.end(), figures.begin(), figures.end());
  PartFile table(file);
  const auto write = [&](const std::string& text) { table.write(text.data(), text.size()); };
  write(csv_line(names));
  for (std::size_t i = 0; i < cases.size(); ++i)
    write(rows_of(markers[i], parameter_cells(study, cases[i], markers[i], keys), figures.size()));
  table.commit();
}

}  // namespace lac::sim
