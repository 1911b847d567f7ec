// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace lac {

/// The system's half of PartFile: an open file that no other run can have open to write, and
/// that can be renamed and removed while it is open. One implementation per system.
///
/// Functions give 0 or the system's code for the refusal, see system_reason().
class LockedFile {
 public:
  static constexpr int kInUse = -1;

  LockedFile() = default;
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;
  ~LockedFile() { close(); }

  /// Creates the file or empties an old one. kInUse: another run has it open.
  int open(const std::filesystem::path& path) noexcept;
  bool is_open() const { return handle_ != kNone; }

  /// Appends all bytes. No allocation.
  int write(const void* bytes, std::size_t count) noexcept;
  /// All bytes from a position on, or it is refused.
  int read(void* bytes, std::size_t count, std::uint64_t position) const noexcept;

  /// Gives the open file another name in the same folder, in one step, replacing an older file.
  int rename(const std::filesystem::path& from, const std::filesystem::path& to) noexcept;
  /// Removes the file, whose name is `path`, and closes it.
  void discard(const std::filesystem::path& path) noexcept;
  void close() noexcept;

 private:
  static constexpr std::intptr_t kNone = -1;  // neither a descriptor nor a HANDLE
  std::intptr_t handle_ = kNone;
};

}  // namespace lac
