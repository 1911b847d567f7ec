// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim_harness/analysis/channel_figures.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "sim_harness/tables/text_reader.hpp"

namespace lac::sim {

/// The runs of one controller: figures under many winds.
struct RunTable {
  struct Run {
    std::string key;  // runs of two controllers with the same key flew in the same wind
    double wind_mps = 0.0;
    std::vector<double> figures;  // NaN: none
    std::string place;            // for messages
    std::size_t row = 0;          // of the table, from 0; of a folder which file
  };
  std::string name;
  std::vector<std::string> figures;  // "TwrBsMyt_del4 [kNm]"
  std::vector<Run> runs;
  std::size_t left_out = 0;           // rows whose status is not "done"
  std::filesystem::path source{};     // table or folder
  std::optional<DelRule> del_rule{};  // of the loads; none: not known
};

struct RunTableOptions {
  /// Column that tells the controllers apart.
  std::string controller_column = "controller";
  /// Columns that make the key. Empty: all without a unit that differ among the runs of one
  /// controller, but case, status and reason; of a column `file` the name without folder and
  /// ending.
  std::vector<std::string> pair_by;
  /// "column=value": other rows of a table are not looked at.
  std::vector<std::string> where;
  /// Mean wind speed. Empty: mean_speed_mps or speed_mps, else the mean of the first that there is
  /// of RtVAvgxh, WindHubVelH, WindHubVelX, Wind1VelX, WindVelX.
  std::string wind_column;
  /// Width of the bins of a wind speed that is a figure (measured); a parameter is taken as it is.
  double bin_mps = 2.0;
};

/// The rows of a table that meet all conditions (where). Throws lac::Error if there is none.
std::vector<std::size_t> chosen_rows(const CsvTable& table, const RunTableOptions& options);

/// Columns that say what a row is (case, status, file, what the loads are), not what was flown.
bool is_bookkeeping(const std::string& column);

/// The values of the controller column, in the order of the table; none if it has no such column.
std::vector<std::string> controllers_in(const CsvTable& table, const RunTableOptions& options);

/// The rows of one controller (all rows if the table has no such column). Figures are the columns
/// with a unit in brackets; rows with a status other than "done" are counted and left out. The
/// columns del_reference and del_rainflow say what the loads are. Throws lac::Error with file and
/// line: two rows of one key, no number where one must be, no wind column or an empty cell in it, a
/// condition that is none or leaves no row, loads of two rules.
RunTable runs_of_table(const CsvTable& table, const std::string& controller,
                       const RunTableOptions& options);

/// The time series of a folder (time_series_of()), their names without ending as keys. One file is
/// one wind: throws lac::Error if two have the same wind that is not constant, as the results of
/// several controllers of one run have; or if a mean wind speed is not there or not finite.
RunTable runs_of_folder(const std::filesystem::path& folder, const FigureOptions& figures,
                        const RunTableOptions& options);

}  // namespace lac::sim
