// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/discon_abi.h"
#include "core/library_image.hpp"

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

  /// Opens the first candidate that exists and looks up the entry (case-sensitive). Everybody in
  /// the process who opens this file shares one image, with one set of static data.
  /// Throws lac::Error that tells apart: not found (all paths tried), not a library, built for
  /// another machine, cannot be loaded (the loader's words), no such entry.
  static DisconLibrary open(const std::string& name, const std::string& entry,
                            const std::vector<std::filesystem::path>& folders);

  /// The same with an image of its own, and so with static data as they are at the start, unless
  /// the library declares itself reentrant (LAC_DISCON_REENTRANT, discon_abi.h). How, and what it
  /// cannot separate: LibraryImage::open_copy. `copy_folders`: where the copy may lie if neither
  /// the system's temporary folder nor that of the library will have it. Throws lac::Error.
  static DisconLibrary open_own(const std::string& name, const std::string& entry,
                                const std::vector<std::filesystem::path>& folders,
                                const std::vector<std::filesystem::path>& copy_folders);

  LacDisconFunction entry() const { return entry_; }
  /// The library as found, not the copy.
  const std::filesystem::path& path() const { return path_; }
  bool has_own_image() const { return has_own_image_; }
  /// Whether it declares itself reentrant: one image then serves several callers at a time.
  bool is_reentrant() const noexcept;

 private:
  void find_entry(const std::string& name);

  LibraryImage image_;
  LacDisconFunction entry_ = nullptr;
  std::filesystem::path path_;
  bool has_own_image_ = false;
};

}  // namespace lac
