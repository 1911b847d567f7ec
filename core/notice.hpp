// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdarg>
#include <cstddef>
#include <string_view>

namespace lac {

/// What one call has to say to the host: the worst level and the texts, joined by "; ". Fixed
/// memory, so that a controller step can use it; a text that does not fit ends in "...".
class Notice {
 public:
  /// printf form. A warning makes aviFAIL 1, a failure -1 (a failure is never downgraded).
  [[gnu::format(printf, 2, 3)]] void warn(const char* format, ...) noexcept;
  [[gnu::format(printf, 2, 3)]] void fail(const char* format, ...) noexcept;

  /// 0, 1 or -1: the value for aviFAIL.
  int level() const { return level_; }
  std::string_view text() const { return {text_.data(), length_}; }

  void clear() noexcept {
    level_ = 0;
    length_ = 0;
  }

 private:
  void append(const char* format, std::va_list args) noexcept;

  int level_ = 0;
  std::size_t length_ = 0;
  std::array<char, 4096> text_;  // no initial value: only length_ characters count
};

}  // namespace lac
