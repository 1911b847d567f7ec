// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "core/native_path.hpp"
#include "support/unique_name.hpp"

namespace lac::test {

/// A folder of its own for one test, removed with the object. Names go in and out as the bytes
/// that a host would pass.
class TempFolder {
 public:
  /// `more` is added to the folder's name.
  explicit TempFolder(const std::string& more = "")
      : path_(std::filesystem::temp_directory_path() / path_from_bytes(unique_name() + more)) {
    if (!std::filesystem::create_directory(path_)) throw std::runtime_error("no temporary folder");
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path path(const std::string& name) const {
    return path_ / path_from_bytes(name);
  }
  std::string file(const std::string& name) const { return bytes_from_path(path(name)); }

  /// Writes a file and gives its path.
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return file(name);
  }
  std::string read(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path path_;
};

}  // namespace lac::test
