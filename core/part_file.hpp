// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "core/locked_file.hpp"

namespace lac {

/// A file that gets its name only when it is complete. Bytes go to "<target>.part"; commit()
/// renames it over the target in one step; destruction without commit() removes it. The part
/// file is locked, so that two runs with the same target cannot mix their bytes.
class PartFile {
 public:
  /// Throws lac::Error naming the file and the reason (folder missing, no permission, in use).
  /// suffix tells apart two part files of one target.
  explicit PartFile(std::filesystem::path target, const char* suffix = ".part");
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// Appends. False when the system refused; the first reason is kept and every later call
  /// fails too. No allocation, no buffer of its own.
  bool write(const void* bytes, std::size_t count) noexcept;

  /// Reads back what was written, from a byte position; throws lac::Error unless all count
  /// bytes are there.
  void read(void* bytes, std::size_t count, std::uint64_t position) const;

  /// Gives the file its name. Throws lac::Error when a write had failed or renaming fails.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path part_;
  LockedFile file_;
  int first_error_ = 0;  // code of the system
};

/// A whole file in one step. Throws lac::Error with file and reason.
void write_whole_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace lac
