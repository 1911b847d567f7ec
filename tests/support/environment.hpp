// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace lac::test {

/// The system's temporary folder is another one while this lives.
class OtherTemporaryFolder {
 public:
  explicit OtherTemporaryFolder(const std::filesystem::path& folder) {
    if (const char* old = std::getenv(kName)) old_ = old;
    set(folder.string());
  }
  ~OtherTemporaryFolder() { set(old_.value_or("")); }
  OtherTemporaryFolder(const OtherTemporaryFolder&) = delete;
  OtherTemporaryFolder& operator=(const OtherTemporaryFolder&) = delete;

 private:
#if defined(_WIN32)
  static constexpr const char* kName = "TMP";
  static void set(const std::string& value) {
    _putenv_s(kName, value.c_str());
  }
#else
  static constexpr const char* kName = "TMPDIR";
  static void set(const std::string& value) {
    if (value.empty()) {
      unsetenv(kName);
    } else {
      setenv(kName, value.c_str(), 1);
    }
  }
#endif
  std::optional<std::string> old_;
};

}  // namespace lac::test
