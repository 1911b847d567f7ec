// SPDX-License-Identifier: Apache-2.0
// The three strings of a DISCON call, read and written so that it works with every host:
// lengths with or without the terminator, rubbish behind it, capacity zero.
#pragma once

#include <algorithm>
#include <cstring>
#include <string_view>

#include "core/swap_view.hpp"

namespace lac {

inline constexpr int kLongestString = 65536;  // a longer length record is not believed

/// Room for texts that OpenFAST lends, records 49 and 64; our harness does as well.
inline constexpr int kOpenFastMessageCapacity = 8197;
inline constexpr int kOpenFastOutNameCapacity = 12601;

/// At most `length` characters, cut at the first NUL, trailing blanks removed.
inline std::string_view read_string(const char* text, int length) {
  if (text == nullptr || length <= 0 || length > kLongestString) return {};
  const auto* end = static_cast<const char*>(std::memchr(text, '\0', static_cast<size_t>(length)));
  std::string_view s(
      text, end != nullptr ? static_cast<size_t>(end - text) : static_cast<size_t>(length));
  while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
  return s;
}

inline std::string_view read_in_file(const char* text, const SwapReader& swap) {
  return read_string(text, swap.integer(Rec::InFileLength, 0));
}
inline std::string_view read_out_name(const char* text, const SwapReader& swap) {
  return read_string(text, swap.integer(Rec::OutNameLength, 0));
}

/// Writes at most `capacity` bytes including the NUL; nothing if there is no room at all.
inline void write_string(char* target, int capacity, std::string_view text) {
  if (target == nullptr || capacity <= 0) return;
  const size_t n = std::min(text.size(), static_cast<size_t>(capacity) - 1);
  std::memcpy(target, text.data(), n);
  target[n] = '\0';
}

}  // namespace lac
