// SPDX-License-Identifier: Apache-2.0
#include "core/discon_library.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <utility>

#include "core/error.hpp"

#if defined(_WIN32)
#include <windows.h>
#else
#include <dlfcn.h>
#if defined(__linux__)
#include <link.h>
#endif
#endif

namespace lac {
namespace fs = std::filesystem;
namespace {

#if defined(_WIN32)
constexpr const char* kSuffix = ".dll";

void* load(const fs::path& path, std::string& reason) {
  HMODULE handle = LoadLibraryW(path.wstring().c_str());
  if (handle == nullptr) reason = "Windows error " + std::to_string(GetLastError());
  return handle;
}
void* symbol(void* handle, const char* name) {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle), name));
}
void unload(void* handle) {
  FreeLibrary(static_cast<HMODULE>(handle));
}
#else
#if defined(__APPLE__)
constexpr const char* kSuffix = ".dylib";
#else
constexpr const char* kSuffix = ".so";
#endif

void* load(const fs::path& path, std::string& reason) {
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) reason = dlerror();
  return handle;
}
void* symbol(void* handle, const char* name) {
  return dlsym(handle, name);
}
void unload(void* handle) {
  dlclose(handle);
}
#endif

#if defined(__linux__)
/// Does the file hold all that its program headers speak of? The loader maps it without asking,
/// and a process that touches a page behind the end of a cut-off file dies (SIGBUS).
bool is_cut_off(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  ElfW(Ehdr) head{};
  in.read(reinterpret_cast<char*>(&head), sizeof head);
  const bool is_ours =
      std::memcmp(head.e_ident, ELFMAG, SELFMAG) == 0 && head.e_phentsize == sizeof(ElfW(Phdr));
  if (!in || !is_ours) return false;  // the loader sees that, and says what it is
  std::error_code ec;
  const std::uintmax_t size = fs::file_size(path, ec);
  in.seekg(static_cast<std::streamoff>(head.e_phoff));
  for (unsigned i = 0; i < head.e_phnum; ++i) {
    ElfW(Phdr) part{};
    if (!in.read(reinterpret_cast<char*>(&part), sizeof part)) return true;
    if (part.p_filesz > size || part.p_offset > size - part.p_filesz) return true;
  }
  return false;
}
#else
bool is_cut_off(const fs::path&) {
  return false;
}
#endif

const char* machine_name(unsigned elf_machine) {
  switch (elf_machine) {
    case 3:
      return "x86";
    case 62:
      return "x86-64";
    case 183:
      return "ARM64";
    default:
      return nullptr;
  }
}

#if defined(__x86_64__)
constexpr const char* kThisMachine = " x86-64";
#elif defined(__aarch64__)
constexpr const char* kThisMachine = " ARM64";
#else
constexpr const char* kThisMachine = "";
#endif

/// What kind of file it is, for the message when it cannot be loaded.
std::string describe(const fs::path& path) {
  std::array<unsigned char, 20> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(reinterpret_cast<char*>(head.data()), head.size());
  if (head[0] == 'M' && head[1] == 'Z') return "a Windows library";
  if (head[0] != 0x7f || head[1] != 'E' || head[2] != 'L' || head[3] != 'F') {
    return "not a library for this system";
  }
  const unsigned machine = head[18] + 256u * head[19];
  const char* name = machine_name(machine);
  return std::string(head[4] == 1 ? "a 32-bit" : "a 64-bit") + " library for " +
         (name != nullptr ? name : ("machine type " + std::to_string(machine)).c_str()) +
         "; this process is " + std::to_string(8 * sizeof(void*)) + "-bit" + kThisMachine;
}

}  // namespace

std::vector<fs::path> library_candidates(const std::string& name,
                                         const std::vector<fs::path>& folders) {
  const fs::path given(name);
  std::vector<fs::path> names{given};
  if (given.extension() != kSuffix) names.emplace_back(name + kSuffix);
  std::vector<fs::path> all;
  if (given.is_absolute()) return names;
  for (const fs::path& folder : folders) {
    for (const fs::path& n : names) all.push_back(folder.empty() ? "." / n : folder / n);
  }
  return all;
}

fs::path own_folder() {
#if defined(_WIN32)
  HMODULE self = nullptr;
  GetModuleHandleExW(
      GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
      reinterpret_cast<LPCWSTR>(&own_folder), &self);
  std::array<wchar_t, 32768> path{};
  GetModuleFileNameW(self, path.data(), static_cast<DWORD>(path.size()));
  return fs::path(path.data()).parent_path();
#else
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&own_folder), &info) == 0 || info.dli_fname == nullptr) {
    return {};
  }
  return fs::path(info.dli_fname).parent_path();
#endif
}

DisconLibrary DisconLibrary::open(const std::string& name, const std::string& entry,
                                  const std::vector<fs::path>& folders) {
  DisconLibrary library;
  std::string tried;
  std::error_code ec;
  for (const fs::path& candidate : library_candidates(name, folders)) {
    tried += "\n  " + candidate.string();
    if (fs::is_regular_file(candidate, ec)) {
      library.path_ = candidate;
      break;
    }
  }
  const bool bare = fs::path(name).filename() == name;
  if (library.path_.empty() && !bare)
    throw Error("library '" + name + "' not found; tried:" + tried);

  std::string reason;
  const fs::path target = library.path_.empty() ? fs::path(name) : fs::absolute(library.path_);
  if (!library.path_.empty() && is_cut_off(target)) {
    throw Error(library.path_.string() +
                ": cannot be loaded: the file is shorter than its own headers say: it was cut off "
                "or is still being written");
  }
  library.handle_ = load(target, reason);
  if (library.handle_ == nullptr && library.path_.empty()) {
    if (!name.ends_with(kSuffix)) library.handle_ = load(name + kSuffix, reason);
    if (library.handle_ == nullptr) {
      throw Error("library '" + name + "' not found; tried:" + tried +
                  "\n  and the system's own search: " + reason);
    }
  }
  if (library.path_.empty()) library.path_ = name;
  if (library.handle_ == nullptr) {
    throw Error(library.path_.string() + ": cannot be loaded: it is " + describe(library.path_) +
                ": " + reason);
  }
  library.entry_ =
      reinterpret_cast<LacDisconFunction>(symbol(library.handle_, entry.c_str()));  // NOLINT
  if (library.entry_ == nullptr) {
    throw Error(library.path_.string() + ": has no entry '" + entry +
                "' (upper and lower case count; most controllers call it DISCON)");
  }
  return library;
}

DisconLibrary::DisconLibrary(DisconLibrary&& o) noexcept {
  *this = std::move(o);
}

DisconLibrary& DisconLibrary::operator=(DisconLibrary&& o) noexcept {
  if (this != &o) {
    close();
    handle_ = std::exchange(o.handle_, nullptr);
    entry_ = std::exchange(o.entry_, nullptr);
    path_ = std::move(o.path_);
  }
  return *this;
}

DisconLibrary::~DisconLibrary() {
  close();
}

void DisconLibrary::close() noexcept {
  if (handle_ != nullptr) unload(handle_);
  handle_ = nullptr;
}

}  // namespace lac
