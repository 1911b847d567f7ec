// SPDX-License-Identifier: Apache-2.0
// What the commands of the program lac do. All throw lac::Error with a text for the user.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace lac::sim {

struct RunOptions {
  std::string case_file;
  std::vector<std::string> overrides;  // "key=value"
  std::string output_folder;           // empty: as the case says
  bool mark = false;                   // leave a marker in output_folder, as in a campaign
};

/// `lac run`: flies a case, prints its table, writes its files.
void run_command(const RunOptions& options, std::ostream& out);

/// `lac check`: reads the input of the master, finds and loads all libraries, makes a first and a
/// last call with the master's own code, its output file left out, prints the order of calls and
/// who reads and writes which record. Throws lac::Error; also if two secondaries write one record
/// that SharedRecords does not name.
void check_command(const std::filesystem::path& wrapper_input, std::ostream& out);

/// `lac trace`: what a host sent and a controller answered, from a file of the host probe. Throws
/// lac::Error.
void trace_command(const std::filesystem::path& file, std::ostream& out);

/// `lac --version`.
void print_version(std::ostream& out);

/// `lac records`: the map of records as a table.
void print_records(std::ostream& out);

}  // namespace lac::sim
