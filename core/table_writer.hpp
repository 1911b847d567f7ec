// SPDX-License-Identifier: Apache-2.0
// One interface for every table of signals over time: the master's log, the harness' results.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace lac {

struct TableChannel {
  std::string name;  // "RotSpeed"; printable ASCII, unique, without comma, quote or blank
  std::string unit;  // "rpm", "-" if none; without brackets; printable ASCII

  bool operator==(const TableChannel&) const = default;
};

/// What a table is; time is not a channel: row i belongs to start_time_s + i time_step_s.
struct TableSpec {
  std::filesystem::path path;
  std::vector<TableChannel> channels;  // at least one
  double start_time_s = 0.0;
  double time_step_s = 0.0;      // > 0
  std::size_t block_rows = 800;  // rows kept in memory between two writes to the disk, >= 1
  std::string description;       // free text, stored where the format has a place for it
};

/// Order of calls: construction, append ... append, finish. The file appears under its own name
/// at finish() and complete, or never: until then rows live in "<path>.part". Destruction
/// without finish(), or after it failed, removes what was begun.
class TableWriter {
 public:
  virtual ~TableWriter() = default;
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;

  /// Takes channels.size() values. Never allocates; writes to the disk once per block. False
  /// once the disk refused a block (finish() then tells why) or after finish().
  virtual bool append(const float* row) noexcept = 0;

  /// Completes the file and gives it its name, replacing an older one in one step. Throws
  /// lac::Error with file and reason; a second call does nothing.
  virtual void finish() = 0;

 protected:
  TableWriter() = default;
};

/// By the ending of spec.path: ".outb" (OpenFAST binary) or ".csv"; any letter case. Throws
/// lac::Error for another ending, for an unusable specification or when the file cannot be
/// begun.
std::unique_ptr<TableWriter> make_table_writer(TableSpec spec);

/// The checks behind the comments in TableSpec; throws lac::Error. Writers call it themselves.
void validate(const TableSpec& spec);

}  // namespace lac
