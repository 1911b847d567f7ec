// SPDX-License-Identifier: Apache-2.0
// What the running test process holds, asked of the system.
#pragma once

#include <cstdint>
#include <filesystem>

#if defined(_WIN32)
#include <windows.h>
// after windows.h
#include <psapi.h>
#else
#include <dlfcn.h>

#include <fstream>
#include <iterator>
#include <string>
#endif

namespace lac::test {
#if defined(_WIN32)

inline bool is_loaded(const std::filesystem::path& library) {
  return GetModuleHandleW(std::filesystem::path(library).make_preferred().c_str()) != nullptr;
}
inline int loaded_libraries() {
  DWORD bytes = 0;
  HMODULE first = nullptr;
  K32EnumProcessModules(GetCurrentProcess(), &first, sizeof first, &bytes);
  return static_cast<int>(bytes / sizeof first);
}
/// Handles of any kind, by the number of the next one, which is the lowest that is free (Wine does
/// not count them).
inline int open_files() {
  HANDLE next = CreateEventW(nullptr, TRUE, FALSE, nullptr);
  CloseHandle(next);
  return static_cast<int>(reinterpret_cast<std::intptr_t>(next) / 4);
}

#else

inline bool is_loaded(const std::filesystem::path& library) {
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_NOLOAD);
  if (handle != nullptr) dlclose(handle);
  return handle != nullptr;
}
/// Mappings of library files, several for each.
inline int loaded_libraries() {
  std::ifstream in("/proc/self/maps");
  int count = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.find(".so") != std::string::npos) ++count;
  }
  return count;
}
inline int open_files() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<int>(std::distance(begin(all), end(all)));
}

#endif
}  // namespace lac::test
