// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <system_error>

namespace lac {

/// Why the system refused, in English: of errno, on Windows of GetLastError() with its number.
inline std::string system_reason(int code) {
#if defined(_WIN32)
  const std::string number = "Windows error " + std::to_string(code);
  const auto general = std::error_code(code, std::system_category()).default_error_condition();
  if (general.category() != std::generic_category()) return number;
  return general.message() + " (" + number + ")";
#else
  return std::generic_category().message(code);
#endif
}

}  // namespace lac
