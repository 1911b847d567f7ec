// SPDX-License-Identifier: Apache-2.0
#include "core/discon_library.hpp"

#include "core/error.hpp"
#include "core/library_file.hpp"
#include "core/native_path.hpp"
#include "core/system_loader.hpp"

namespace lac {
namespace fs = std::filesystem;
namespace {

constexpr const char* kReentrantSymbol = "LAC_DISCON_REENTRANT";

/// As written and with the suffix of this system.
std::vector<fs::path> names_of(const std::string& name) {
  std::vector<fs::path> names{path_from_bytes(name)};
  if (names[0].extension() != loader::kSuffix)
    names.push_back(path_from_bytes(name + loader::kSuffix));
  return names;
}

/// The first candidate that exists; empty if none does. `tried` lists them.
fs::path find_library(const std::string& name, const std::vector<fs::path>& folders,
                      std::string& tried) {
  std::error_code ec;
  for (const fs::path& candidate : library_candidates(name, folders)) {
    tried += "\n  " + candidate.string();
    if (fs::is_regular_file(candidate, ec)) return candidate;
  }
  return {};
}

LibraryImage load_file(const fs::path& path) {
  const fs::path target = fs::absolute(path);
  if (is_cut_off(target)) {
    throw Error(path.string() +
                ": cannot be loaded: the file is shorter than its own headers say: it was cut off "
                "or is still being written");
  }
  std::string reason;
  LibraryImage image = LibraryImage::open(target, reason);
  if (image) return image;
  const std::string kind = describe_library(path);
  throw Error(path.string() +
              ": cannot be loaded: " + (kind.empty() ? reason : "it is " + kind + ": " + reason));
}

/// By the system's own search. What it finds is no file that could be looked at first.
LibraryImage load_by_system(const std::string& name, const std::string& tried) {
  std::string reason;
  for (const fs::path& n : names_of(name)) {
    if (LibraryImage image = LibraryImage::open(n, reason)) return image;
  }
  throw Error("library '" + name + "' not found; tried:" + tried +
              "\n  and the system's own search: " + reason);
}

}  // namespace

std::vector<fs::path> library_candidates(const std::string& name,
                                         const std::vector<fs::path>& folders) {
  std::vector<fs::path> names = names_of(name);
  if (names[0].is_absolute()) return names;
  std::vector<fs::path> all;
  for (const fs::path& folder : folders) {
    for (const fs::path& n : names) all.push_back(folder.empty() ? "." / n : folder / n);
  }
  return all;
}

fs::path own_folder() {
  return loader::file_of(reinterpret_cast<const void*>(&own_folder)).parent_path();
}

DisconLibrary DisconLibrary::open(const std::string& name, const std::string& entry,
                                  const std::vector<fs::path>& folders) {
  DisconLibrary library;
  std::string tried;
  library.path_ = find_library(name, folders, tried);
  if (!library.path_.empty()) {
    library.image_ = load_file(library.path_);
  } else if (path_from_bytes(name).has_parent_path()) {
    throw Error("library '" + name + "' not found; tried:" + tried);
  } else {
    library.image_ = load_by_system(name, tried);
    library.path_ = path_from_bytes(name);
  }
  library.find_entry(entry);
  return library;
}

DisconLibrary DisconLibrary::open_own(const std::string& name, const std::string& entry,
                                      const std::vector<fs::path>& folders,
                                      const std::vector<fs::path>& copy_folders) {
  DisconLibrary library = open(name, entry, folders);
  if (library.is_reentrant()) return library;

  const LacDisconFunction shared = library.entry_;
  const fs::path file = loader::file_of(reinterpret_cast<const void*>(shared));
  std::vector<fs::path> places{file.parent_path()};
  places.insert(places.end(), copy_folders.begin(), copy_folders.end());
  DisconLibrary own;
  own.path_ = library.path_;
  own.image_ = LibraryImage::open_copy(file, places);
  own.find_entry(entry);
  own.has_own_image_ = true;
  if (own.entry_ == shared) {
    throw Error(own.path_.string() + ": the system gave its copy the static data of the original");
  }
  return own;
}

bool DisconLibrary::is_reentrant() const noexcept {
  const auto* declared = static_cast<const int*>(image_.symbol(kReentrantSymbol));
  return declared != nullptr && *declared != 0;
}

void DisconLibrary::find_entry(const std::string& name) {
  entry_ = reinterpret_cast<LacDisconFunction>(image_.symbol(name.c_str()));  // NOLINT
  if (entry_ != nullptr) return;
  throw Error(path_.string() + ": has no entry '" + name +
              "' (upper and lower case count; most controllers call it DISCON)");
}

}  // namespace lac
