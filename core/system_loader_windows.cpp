// SPDX-License-Identifier: Apache-2.0
#include <windows.h>

#include <vector>

#include "core/native_path.hpp"
#include "core/system_loader.hpp"
#include "core/system_reason.hpp"

namespace lac::loader {
namespace fs = std::filesystem;
namespace {

std::string last_reason() {
  return system_reason(static_cast<int>(GetLastError()));
}

/// Names of the libraries that this one is linked to and that are not to be found: the system says
/// only that there are some.
std::string missing_parts(const fs::path& file) {
  HMODULE image = LoadLibraryExW(file.c_str(), nullptr, DONT_RESOLVE_DLL_REFERENCES);
  if (image == nullptr) return {};
  const auto* base = reinterpret_cast<const char*>(image);
  const auto* dos = reinterpret_cast<const IMAGE_DOS_HEADER*>(base);
  const auto* headers = reinterpret_cast<const IMAGE_NT_HEADERS*>(base + dos->e_lfanew);
  const IMAGE_DATA_DIRECTORY& table =
      headers->OptionalHeader.DataDirectory[IMAGE_DIRECTORY_ENTRY_IMPORT];
  std::string missing;
  const auto* part = reinterpret_cast<const IMAGE_IMPORT_DESCRIPTOR*>(base + table.VirtualAddress);
  for (; table.Size > 0 && part->Name != 0; ++part) {
    const char* name = base + part->Name;
    std::error_code ec;
    const bool found = GetModuleHandleA(name) != nullptr ||
                       fs::exists(file.parent_path() / path_from_bytes(name), ec) ||
                       SearchPathA(nullptr, name, nullptr, 0, nullptr, nullptr) > 0;
    if (!found) missing += (missing.empty() ? "" : ", ") + std::string(name);
  }
  FreeLibrary(image);
  return missing;
}

std::string reason_not_loaded(const fs::path& file, DWORD code) {
  const std::string number = " (Windows error " + std::to_string(code) + ")";
  if (code == ERROR_MOD_NOT_FOUND) {
    const std::string missing = file.is_absolute() ? missing_parts(file) : "";
    if (missing.empty()) return "it, or a library that it needs, is not found" + number;
    return "it needs " + missing + ", not found beside it nor by the system" + number;
  }
  if (code == ERROR_BAD_EXE_FORMAT) return "not a library for this process" + number;
  if (code == ERROR_DLL_INIT_FAILED) return "its start-up code failed" + number;
  return system_reason(static_cast<int>(code));
}

}  // namespace

const char* const kSuffix = ".dll";
const bool kFileMayGo = false;

// With its folder in the search for the libraries it needs.
void* load(const fs::path& file, std::string& reason) {
  const DWORD flags = file.is_absolute() ? LOAD_WITH_ALTERED_SEARCH_PATH : 0;
  HMODULE handle = LoadLibraryExW(file.c_str(), nullptr, flags);
  if (handle == nullptr) reason = reason_not_loaded(file, GetLastError());
  return handle;
}

void* symbol(void* handle, const char* name) noexcept {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle), name));
}

void unload(void* handle) noexcept {
  FreeLibrary(static_cast<HMODULE>(handle));
}

fs::path file_of(const void* address) {
  HMODULE module = nullptr;
  GetModuleHandleExW(
      GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
      static_cast<LPCWSTR>(address), &module);
  std::vector<wchar_t> path(32768);
  const DWORD length = GetModuleFileNameW(module, path.data(), static_cast<DWORD>(path.size()));
  return std::wstring(path.data(), length);
}

// Temporary folders belong to one user there.
fs::path make_own_folder(const fs::path& parent, const std::string& prefix, std::string& reason) {
  const std::string start = prefix + std::to_string(GetCurrentProcessId()) + "_";
  for (;;) {
    LARGE_INTEGER ticks{};
    QueryPerformanceCounter(&ticks);
    const fs::path folder = parent / (start + std::to_string(ticks.QuadPart));
    if (CreateDirectoryW(folder.c_str(), nullptr) != 0) return folder;
    if (GetLastError() == ERROR_ALREADY_EXISTS) continue;
    reason = last_reason();
    return {};
  }
}

bool process_runs(long id) {
  HANDLE process = OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(id));
  if (process == nullptr) return GetLastError() != ERROR_INVALID_PARAMETER;
  const bool runs = WaitForSingleObject(process, 0) == WAIT_TIMEOUT;
  CloseHandle(process);
  return runs;
}

}  // namespace lac::loader
