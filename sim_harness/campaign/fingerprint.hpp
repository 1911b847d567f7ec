// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lac::sim {

/// Tells whether a case would still give the same numbers: a hash of all they come from, by
/// content, not by place or date. These are the program, the case file, the overrides, and every
/// file that is named in one of those or in a file named there, and so on; names of libraries count
/// as the files that would be loaded. A text may name a file relative to its own folder.
///
/// Files are looked at once per object.
class Fingerprints {
 public:
  /// 16 hexadecimal digits. Throws lac::Error if the case file cannot be read.
  std::string of_case(const std::filesystem::path& case_file,
                      const std::vector<std::string>& overrides);

 private:
  struct File {
    std::uint64_t hash = 0;
    std::vector<std::filesystem::path> named;
  };
  const File& look_at(const std::filesystem::path& file);
  std::vector<std::filesystem::path> named_in(const std::string& text,
                                              const std::filesystem::path& folder);

  std::map<std::filesystem::path, File> files_;
};

}  // namespace lac::sim
