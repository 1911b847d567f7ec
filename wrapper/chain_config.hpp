// SPDX-License-Identifier: Apache-2.0
// What the master's input file says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/discon_library.hpp"
#include "core/input_file.hpp"
#include "core/openfast_lidar.hpp"
#include "core/table_writer.hpp"

namespace lac {

/// One row `"name" "library" "input file" ["entry"] ! Secondary_n`.
struct SecondaryParams {
  std::string where;                 // "<file>:<line>: Secondary_n", in front of errors
  std::string name;                  // letters, digits, - and _: part of file names and messages
  std::string library;               // as written
  std::filesystem::path input_file;  // found and readable
  std::string entry = "DISCON";
  bool reentrant = false;  // ReentrantSecondaries: shares one image with all who open the library
  bool guo = false;        // GuoSecondaries: record 63 is a lidar block of Guo's layout for it

  /// All rows, with names that differ. Throws lac::Error.
  static std::vector<SecondaryParams> read_all(InputFile& in);
};

/// One row `"name" record ["unit"] ! Signal_n`: a record of kSignalBlock by which secondaries tell
/// each other something. It keeps its value from call to call and over a restart.
struct NamedSignal {
  std::string name;  // of no record and no other signal
  int record = 0;    // of no other signal
  std::string unit = "-";

  /// All rows; none is fine. Throws lac::Error.
  static std::vector<NamedSignal> read_all(InputFile& in);
};

/// "rec120" -> 120; 0 if the word means no record of the private array.
int raw_record(const std::string& word);

/// Which lidar records of the host reach the secondaries.
enum class HostLidar { None, Native, Guo, OpenFast };

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

  /// The record that a word of a key means, by its name, that of a signal, or as rec120.
  /// Throws lac::Error.
  static OutputChannel find_channel(const InputFile& in, const std::string& key,
                                    const std::string& word,
                                    const std::vector<NamedSignal>& signals);

  /// Channels may be named signals. Throws lac::Error.
  static OutputParams read(InputFile& in, const std::vector<NamedSignal>& signals);

  /// Where the file goes: a relative name counts from the folder of the host's root name.
  std::filesystem::path path(const std::string& host_out_name) const;
};

struct WrapperParams {
  std::filesystem::path file;
  std::vector<SecondaryParams> secondaries;  // in the order of calls
  std::vector<NamedSignal> signals;
  HostLidar lidar = HostLidar::None;
  OpenFastLidarParams openfast_lidar;  // for Guo-type secondaries on OpenFAST's lidar
  bool extended_demands = false;       // 2601-3000: cable and structural control
  std::vector<int> shared_records;     // SharedRecords: more than one secondary may write them
  OutputParams output;

  /// Reads and checks every key, and that every input file of a secondary can be opened (some
  /// controllers end the process when theirs is missing). Throws lac::Error.
  static WrapperParams read(InputFile& in);

  /// Opens the library of a secondary: folder of the master's input file, then `wrapper_folder`
  /// (where liblac_wrapper.so lies), then the system's search. A library that is not reentrant is
  /// opened with an image of its own, whose file may lie in `run_folder` if it must.
  /// Throws lac::Error.
  DisconLibrary open_library(const SecondaryParams& secondary,
                             const std::filesystem::path& wrapper_folder,
                             const std::filesystem::path& run_folder = {}) const;
};

}  // namespace lac
