// SPDX-License-Identifier: Apache-2.0
#include "core/notice.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace lac {

void Notice::warn(const char* format, ...) noexcept {
  if (level_ == 0) level_ = 1;
  va_list args;
  va_start(args, format);
  append(format, args);
  va_end(args);
}

void Notice::fail(const char* format, ...) noexcept {
  level_ = -1;
  va_list args;
  va_start(args, format);
  append(format, args);
  va_end(args);
}

void Notice::append(const char* format, std::va_list args) noexcept {
  constexpr std::string_view kCut = "...";
  const std::size_t room_for_cut = text_.size() - 1 - kCut.size();
  const auto cut = [&] {
    std::memcpy(text_.data() + room_for_cut, kCut.data(), kCut.size());
    length_ = room_for_cut + kCut.size();
  };
  if (length_ > room_for_cut) return cut();
  if (length_ > 0) {
    const std::size_t n = std::min<std::size_t>(2, room_for_cut - length_);
    std::memcpy(text_.data() + length_, "; ", n);
    length_ += n;
  }
  const int written = std::vsnprintf(text_.data() + length_, text_.size() - length_, format, args);
  if (written < 0) return;
  if (length_ + static_cast<std::size_t>(written) < text_.size()) {
    length_ += static_cast<std::size_t>(written);
    return;
  }
  cut();
}

}  // namespace lac
