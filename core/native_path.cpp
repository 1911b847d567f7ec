// SPDX-License-Identifier: Apache-2.0
#include "core/native_path.hpp"

#if defined(_WIN32)
#include <windows.h>
#endif

namespace lac {
#if defined(_WIN32)
namespace {

/// False if `flags` ask for strictness and the bytes do not follow the code page.
bool to_wide(unsigned code_page, unsigned long flags, std::string_view bytes, std::wstring& wide) {
  const int size = static_cast<int>(bytes.size());
  const int length = MultiByteToWideChar(code_page, flags, bytes.data(), size, nullptr, 0);
  wide.resize(static_cast<std::size_t>(length));
  return MultiByteToWideChar(code_page, flags, bytes.data(), size, wide.data(), length) > 0;
}

/// Empty if the code page has no place for a character, or is UTF-8 itself.
std::string to_ansi(const std::wstring& wide) {
  const int size = static_cast<int>(wide.size());
  const auto convert = [&](char* target, int room) {
    return WideCharToMultiByte(CP_ACP, WC_NO_BEST_FIT_CHARS, wide.data(), size, target, room,
                               nullptr, nullptr);
  };
  std::string bytes(static_cast<std::size_t>(convert(nullptr, 0)), '\0');
  convert(bytes.data(), static_cast<int>(bytes.size()));
  return bytes;
}

}  // namespace

std::filesystem::path path_from_bytes(std::string_view bytes) {
  std::wstring wide;
  if (!to_wide(CP_UTF8, MB_ERR_INVALID_CHARS, bytes, wide)) to_wide(CP_ACP, 0, bytes, wide);
  return wide;
}

std::string bytes_from_path(const std::filesystem::path& path) {
  std::string ansi = to_ansi(path.native());
  return path_from_bytes(ansi) == path ? ansi : path.string();
}
#else
std::filesystem::path path_from_bytes(std::string_view bytes) {
  return bytes;
}

std::string bytes_from_path(const std::filesystem::path& path) {
  return path.string();
}
#endif
}  // namespace lac
