// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lac {

/// A library file in memory: its code and one set of its static data. Unloaded with the object.
/// Move only.
class LibraryImage {
 public:
  LibraryImage() = default;

  /// The image that everybody in the process shares who opens this file. If the system refuses, the
  /// result is empty and `reason` has its words.
  static LibraryImage open(const std::filesystem::path& file, std::string& reason);

  /// One more image, with static data of its own, of a library that is open: a copy of its file,
  /// loaded under another name. The libraries it needs are found because the open one has loaded
  /// them, also if its search path counts from its own folder; they, and what C++ calls unique
  /// symbols, stay common to all images. Start-up code runs again in each image.
  ///
  /// The copy lies in a folder of its own, closed to others, in the system's temporary folder or,
  /// if that is full or allows no programs, in the first of `more_folders` that works. It is
  /// removed as soon as it is loaded (on Windows when it is unloaded; what a crash left there goes
  /// when the next one is made). Throws lac::Error with every place tried.
  static LibraryImage open_copy(const std::filesystem::path& file,
                                const std::vector<std::filesystem::path>& more_folders);

  LibraryImage(LibraryImage&& other) noexcept;
  LibraryImage& operator=(LibraryImage&& other) noexcept;
  LibraryImage(const LibraryImage&) = delete;
  LibraryImage& operator=(const LibraryImage&) = delete;
  ~LibraryImage();

  explicit operator bool() const { return handle_ != nullptr; }

  /// Address of a symbol (case-sensitive), or nullptr.
  void* symbol(const char* name) const noexcept;

 private:
  static LibraryImage open_copy_in(const std::filesystem::path& parent,
                                   const std::filesystem::path& file, std::string& reason);
  void close() noexcept;

  void* handle_ = nullptr;
  std::filesystem::path folder_;  // to be removed with the image
};

}  // namespace lac
