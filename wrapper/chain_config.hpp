// SPDX-License-Identifier: Apache-2.0
// What the master's input file says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/discon_library.hpp"
#include "core/input_file.hpp"
#include "core/table_writer.hpp"

namespace lac {

/// One row `"name" "library" "input file" ["entry"] ! Secondary_n`.
struct SecondaryParams {
  std::string where;                 // "<file>:<line>: Secondary_n", in front of errors
  std::string name;                  // letters, digits, - and _: part of file names and messages
  std::string library;               // as written
  std::filesystem::path input_file;  // found and readable
  std::string entry = "DISCON";
};

/// Which lidar records of the host reach the secondaries.
enum class HostLidar { None, Native, Guo };

/// Root name of the run: what the host passes without OpenFAST's ".SrvD".
std::string without_host_suffix(const std::string& host_out_name);

struct OutputChannel {
  int record = 0;
  TableChannel channel;
};

struct OutputParams {
  bool enabled = false;
  std::string ending;          // ".outb" or ".csv"
  std::filesystem::path file;  // as written; empty: <root name of the host>.lac<ending>
  int decimation = 1;          // one row every so many calls
  std::vector<OutputChannel> channels;

  /// Where the file goes: a relative name counts from the folder of the host's root name.
  std::filesystem::path path(const std::string& host_out_name) const;
};

struct WrapperParams {
  std::filesystem::path file;
  std::vector<SecondaryParams> secondaries;  // in the order of calls
  HostLidar lidar = HostLidar::None;
  bool extended_demands = false;  // 2601-3000: cable and structural control
  OutputParams output;

  /// Reads and checks every key, and that every input file of a secondary can be opened (some
  /// controllers end the process when theirs is missing). Throws lac::Error.
  static WrapperParams read(InputFile& in);

  /// Opens the library of a secondary: folder of the master's input file, then `wrapper_folder`
  /// (where liblac_wrapper.so lies), then the system's search. Throws lac::Error.
  DisconLibrary open_library(const SecondaryParams& secondary,
                             const std::filesystem::path& wrapper_folder) const;
};

}  // namespace lac
