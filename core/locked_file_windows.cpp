// SPDX-License-Identifier: Apache-2.0
#include <windows.h>

#include <algorithm>

#include "core/locked_file.hpp"

namespace lac {
namespace {

constexpr DWORD kMostAtOnce = 1U << 30;  // counts are 32-bit here

HANDLE as_handle(std::intptr_t handle) {
  return reinterpret_cast<HANDLE>(handle);  // NOLINT
}

int last_error() {
  return static_cast<int>(GetLastError());
}

DWORD portion(std::size_t count) {
  return static_cast<DWORD>(std::min<std::size_t>(count, kMostAtOnce));
}

}  // namespace

// Shared for renaming and removing alone: nobody else gets it open to read or write.
int LockedFile::open(const std::filesystem::path& path) noexcept {
  const HANDLE handle = CreateFileW(path.c_str(), GENERIC_READ | GENERIC_WRITE, FILE_SHARE_DELETE,
                                    nullptr, CREATE_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (handle == INVALID_HANDLE_VALUE) {
    const int code = last_error();
    return code == ERROR_SHARING_VIOLATION ? kInUse : code;
  }
  handle_ = reinterpret_cast<std::intptr_t>(handle);  // NOLINT
  return 0;
}

int LockedFile::write(const void* bytes, std::size_t count) noexcept {
  const char* next = static_cast<const char*>(bytes);
  LARGE_INTEGER end{};
  if (!SetFilePointerEx(as_handle(handle_), end, nullptr, FILE_END)) return last_error();
  while (count > 0) {
    DWORD written = 0;
    if (!WriteFile(as_handle(handle_), next, portion(count), &written, nullptr)) {
      return last_error();
    }
    next += written;
    count -= written;
  }
  return 0;
}

int LockedFile::read(void* bytes, std::size_t count, std::uint64_t position) const noexcept {
  char* next = static_cast<char*>(bytes);
  while (count > 0) {
    OVERLAPPED from{};
    from.Offset = static_cast<DWORD>(position);
    from.OffsetHigh = static_cast<DWORD>(position >> 32);
    DWORD got = 0;
    if (!ReadFile(as_handle(handle_), next, portion(count), &got, &from)) return last_error();
    if (got == 0) return ERROR_HANDLE_EOF;
    next += got;
    position += got;
    count -= got;
  }
  return 0;
}

int LockedFile::rename(const std::filesystem::path& from,
                       const std::filesystem::path& to) noexcept {
  return MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING) ? 0 : last_error();
}

void LockedFile::discard(const std::filesystem::path& path) noexcept {
  DeleteFileW(path.c_str());
  close();
}

void LockedFile::close() noexcept {
  if (is_open()) CloseHandle(as_handle(handle_));
  handle_ = kNone;
}

}  // namespace lac
