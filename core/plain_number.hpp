// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace lac {

/// The number that the whole word is, whatever the locale; nothing if it is none. "inf" and "nan"
/// are numbers, "+1" is none (without_plus).
inline std::optional<double> plain_number(std::string_view word) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// For files whose numbers may have a sign of either kind.
inline std::string_view without_plus(std::string_view word) {
  return word.substr(word.starts_with('+') ? 1 : 0);
}

}  // namespace lac
