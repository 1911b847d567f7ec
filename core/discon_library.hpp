// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/discon_abi.h"

namespace lac {

/// Where a library may lie: `name` as written (with or without suffix) in each of the folders,
/// in their order. An absolute name stands alone.
std::vector<std::filesystem::path> library_candidates(
    const std::string& name, const std::vector<std::filesystem::path>& folders);

/// Folder of the library this code is linked into. (A program found through PATH is not known by
/// its folder this way.)
std::filesystem::path own_folder();

/// A controller library held open, with its entry; closed with the object. Move only.
class DisconLibrary {
 public:
  DisconLibrary() = default;

  /// Opens the first candidate that exists and looks up the entry (case-sensitive).
  /// Throws lac::Error that tells apart: not found (all paths tried), not a library, built for
  /// another machine, cannot be loaded (the loader's words), no such entry.
  static DisconLibrary open(const std::string& name, const std::string& entry,
                            const std::vector<std::filesystem::path>& folders);

  DisconLibrary(DisconLibrary&& other) noexcept;
  DisconLibrary& operator=(DisconLibrary&& other) noexcept;
  DisconLibrary(const DisconLibrary&) = delete;
  DisconLibrary& operator=(const DisconLibrary&) = delete;
  ~DisconLibrary();

  LacDisconFunction entry() const { return entry_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  void close() noexcept;

  void* handle_ = nullptr;
  LacDisconFunction entry_ = nullptr;
  std::filesystem::path path_;
};

}  // namespace lac
