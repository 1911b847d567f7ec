// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <string>

#include "core/input_file.hpp"

namespace lac {

/// Keys "<prefix>1", "<prefix>2", ... of an input file: how many there are. A gap, or more than
/// `most`, is an error; `things` is what a row describes.
inline int count_numbered_rows(InputFile& in, const std::string& prefix, int most,
                               const std::string& things) {
  const auto key = [&](int n) { return prefix + std::to_string(n); };
  int count = 0;
  for (int n = 1; n <= most; ++n) {
    if (!in.has(key(n))) continue;
    if (n != count + 1) {
      in.fail(key(n), key(count + 1) + " is missing: number the rows 1, 2, 3 ... without a gap");
    }
    count = n;
  }
  if (in.has(key(most + 1))) {
    in.fail(key(most + 1), "expected at most " + std::to_string(most) + " " + things);
  }
  return count;
}

/// The whole number that the text is, or `otherwise`.
inline int whole_number(std::string_view text, int otherwise) {
  int number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size() ? number : otherwise;
}

}  // namespace lac
