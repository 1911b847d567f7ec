// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/text_reader.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim_harness/tables/text_lines.hpp"
#include "sim_harness/tables/text_number.hpp"
#include "sim_harness/tables/time_axis.hpp"

namespace lac::sim {
namespace {

constexpr std::size_t kMostShown = 40;

/// Rows of numbers below the names, the time first.
class Rows {
 public:
  Rows(TextLines& lines, std::vector<TableChannel> channels, char separator)
      : lines_(lines), channels_(std::move(channels)), separator_(separator) {}

  void take_units() {
    split_cells(lines_.text(), separator_, cells_);
    if (cells_.size() != channels_.size() + 1) {
      lines_.fail("found " + std::to_string(cells_.size()) + " units, expected " +
                  std::to_string(channels_.size() + 1) + " as in the line of names");
    }
    for (std::size_t i = 0; i < channels_.size(); ++i)
      channels_[i].unit = without_brackets(cells_[i + 1]);
  }

  void take() {
    split_cells(lines_.text(), separator_, cells_);
    if (cells_.size() != channels_.size() + 1) {
      lines_.fail("found " + std::to_string(cells_.size()) + " columns, expected " +
                  std::to_string(channels_.size() + 1) + " as in the line of names");
    }
    times_s_.push_back(number(0));
    for (std::size_t i = 1; i < cells_.size(); ++i)
      values_.push_back(static_cast<float>(number(i)));
    line_of_row_.push_back(lines_.number());
  }

  Recording recording(MissingRows missing) const {
    if (times_s_.empty()) lines_.fail_as_a_whole("found no row of numbers, expected one");
    const TimeAxis axis = time_axis_of(times_s_, [&](std::size_t row, const std::string& problem) {
      lines_.fail_at(line_of_row_[row], problem);
    });
    if (axis.has_gaps() && missing == MissingRows::kRefused) refuse(axis);
    const std::size_t rows = axis.has_gaps() ? axis.place.back() + 1 : times_s_.size();
    Recording recording(channels_, axis.start_s, axis.step_s, rows);
    const std::vector<float> nothing(channels_.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < times_s_.size(); ++i) {
      while (axis.has_gaps() && recording.rows() < axis.place[i]) recording.append(nothing.data());
      recording.append(values_.data() + i * channels_.size());
    }
    return recording;
  }

 private:
  double number(std::size_t column) {
    std::string with_point;
    std::string_view cell = cells_[column];
    if (separator_ == ';' && cell.find(',') != std::string_view::npos) {
      with_point = cell;
      with_point[with_point.find(',')] = '.';
      cell = with_point;
    }
    if (const auto value = number_in(cell)) return *value;
    const std::string name = column == 0 ? "Time" : channels_[column - 1].name;
    lines_.fail("column " + std::to_string(column + 1) + " (" + name + "): found '" +
                std::string(cell.substr(0, kMostShown)) + "', expected a number" +
                (cell.starts_with('*') ? "; stars stand where one did not fit its field" : ""));
  }

  [[noreturn]] void refuse(const TimeAxis& axis) const {
    std::size_t row = 1;
    while (axis.place[row] == row) ++row;
    lines_.fail_at(line_of_row_[row],
                   "rows are missing before this one, expected equidistant times (with "
                   "--missing-rows they count as gaps)");
  }

  TextLines& lines_;
  std::vector<TableChannel> channels_;
  char separator_;
  Cells cells_;
  std::vector<double> times_s_;
  std::vector<float> values_;
  std::vector<std::size_t> line_of_row_;
};

/// "RotSpeed [rpm]", "RotSpeed (rpm)" or a name alone.
TableChannel channel_of(std::string_view cell) {
  const std::size_t open = cell.find_last_of("([");
  const bool with_unit =
      open != std::string_view::npos && open > 0 && (cell.back() == ')' || cell.back() == ']');
  if (!with_unit) return {std::string(cell), "-"};
  return {std::string(trimmed(cell.substr(0, open))), without_brackets(cell.substr(open))};
}

bool is_time(std::string_view name) {
  return equal_ignoring_case(name.substr(0, 4), "time") || equal_ignoring_case(name, "t");
}

char separator_of(std::string_view names) {
  for (const char c : {';', '\t'})
    if (names.find(c) != std::string_view::npos) return c;
  return ',';
}

bool passed_over(const TextLines& lines) {
  return lines.is_empty() || lines.text().front() == '#';
}

std::vector<TableChannel> channels_of(const Cells& names, const TextLines& lines) {
  if (names.size() < 2) lines.fail("found no name behind the time, expected one per channel");
  std::vector<TableChannel> channels;
  for (std::size_t i = 1; i < names.size(); ++i) channels.push_back(channel_of(names[i]));
  return channels;
}

void refuse_doubles(const std::vector<TableChannel>& channels, const TextLines& lines) {
  std::set<std::string> names;
  for (const TableChannel& c : channels)
    if (!names.insert(c.name).second) lines.fail("the name '" + c.name + "' stands twice");
}

}  // namespace

Recording read_out(const std::filesystem::path& file, MissingRows missing) {
  TextLines lines(file);
  Cells cells;
  while (cells.empty() || !equal_ignoring_case(cells[0], "time")) {
    if (!lines.next())
      lines.fail_as_a_whole("found no line that begins with 'Time', expected the channels' names");
    split_cells(lines.text(), kBlanks, cells);
  }
  Rows rows(lines, channels_of(cells, lines), kBlanks);
  if (!lines.next() || !trimmed(lines.text()).starts_with('('))
    lines.fail("expected a line of units in brackets below the names");
  rows.take_units();
  bool after_empty_line = false;
  while (lines.next()) {
    split_cells(lines.text(), kBlanks, cells);
    if (after_empty_line && !cells.empty() && !number_in(cells[0])) break;
    after_empty_line = cells.empty();
    if (!cells.empty()) rows.take();
  }
  return rows.recording(missing);
}

Recording read_csv(const std::filesystem::path& file, MissingRows missing) {
  TextLines lines(file);
  do {
    if (!lines.next()) lines.fail_as_a_whole("found no line of names, expected one");
  } while (passed_over(lines));
  const char separator = separator_of(lines.text());
  Cells cells;
  split_cells(lines.text(), separator, cells);
  if (!is_time(cells[0])) {
    lines.fail("found '" + std::string(cells[0].substr(0, kMostShown)) +
               "' as name of the first column, expected Time [s]");
  }
  std::vector<TableChannel> channels = channels_of(cells, lines);
  refuse_doubles(channels, lines);
  Rows rows(lines, std::move(channels), separator);
  bool units_may_follow = true;
  while (lines.next()) {
    if (passed_over(lines)) continue;
    split_cells(lines.text(), separator, cells);
    if (units_may_follow && !number_in(cells[0])) {
      rows.take_units();
    } else {
      rows.take();
    }
    units_may_follow = false;
  }
  return rows.recording(missing);
}

}  // namespace lac::sim
