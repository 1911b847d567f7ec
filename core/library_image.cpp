// SPDX-License-Identifier: Apache-2.0
#include "core/library_image.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "core/error.hpp"
#include "core/locked_file.hpp"
#include "core/system_loader.hpp"
#include "core/system_reason.hpp"

namespace lac {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPrefix = "lac_image_";

/// Longer than a copy needs to be made and loaded, also by a process whose id means nothing here.
constexpr std::chrono::minutes kSurelyLoaded{10};

/// Folders of processes that were ended before they could remove them.
void remove_left_behind(const fs::path& parent) noexcept {
  std::error_code ec;
  for (fs::directory_iterator entry(parent, ec), end; !ec && entry != end; entry.increment(ec)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(kPrefix)) continue;
    const long owner = std::strtol(name.c_str() + std::string_view(kPrefix).size(), nullptr, 10);
    std::error_code unknown;
    const auto changed = fs::last_write_time(entry->path(), unknown);
    if (unknown || fs::file_time_type::clock::now() - changed < kSurelyLoaded) continue;
    if (owner > 0 && !loader::process_runs(owner)) fs::remove_all(entry->path(), unknown);
  }
}

std::vector<fs::path> places(const std::vector<fs::path>& more_folders, std::string& tried) {
  std::vector<fs::path> all;
  std::error_code ec;
  const fs::path temporary = fs::temp_directory_path(ec);
  if (ec) {
    tried += "\n  the system's temporary folder: " + ec.message();
  } else {
    all.push_back(temporary);
    remove_left_behind(temporary);
  }
  for (const fs::path& folder : more_folders) all.push_back(folder.empty() ? "." : folder);
  return all;
}

/// Gives the system's reason, empty if all went well. (std::filesystem calls a full disk an
/// input/output error.)
std::string copy_bytes(const fs::path& from, const fs::path& to) {
  std::ifstream in(from, std::ios::binary);
  if (!in) return "the library itself cannot be read";
  LockedFile out;
  if (const int code = out.open(to); code != 0) return system_reason(code);
  std::vector<char> bytes(std::size_t{1} << 16);
  do {
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const int code = out.write(bytes.data(), static_cast<std::size_t>(in.gcount()));
    if (code != 0) return system_reason(code);
  } while (in);
  return in.eof() ? "" : "the library itself cannot be read to its end";
}

void remove_folder(const fs::path& folder) noexcept {
  std::error_code ignored;
  if (!folder.empty()) fs::remove_all(folder, ignored);
}

}  // namespace

LibraryImage LibraryImage::open(const fs::path& file, std::string& reason) {
  LibraryImage image;
  image.handle_ = loader::load(file, reason);
  return image;
}

LibraryImage LibraryImage::open_copy(const fs::path& file,
                                     const std::vector<fs::path>& more_folders) {
  std::string tried;
  for (const fs::path& parent : places(more_folders, tried)) {
    std::string reason;
    LibraryImage image = open_copy_in(parent, file, reason);
    if (image) return image;
    tried += "\n  " + parent.string() + ": " + reason;
  }
  throw Error(file.string() +
              ": cannot be copied to give it static data of its own; tried:" + tried);
}

LibraryImage LibraryImage::open_copy_in(const fs::path& parent, const fs::path& file,
                                        std::string& reason) {
  LibraryImage image;
  image.folder_ = loader::make_own_folder(parent, kPrefix, reason);
  if (image.folder_.empty()) return image;
  const fs::path copy = fs::absolute(image.folder_) / file.filename();
  reason = copy_bytes(file, copy);
  if (reason.empty()) image.handle_ = loader::load(copy, reason);
  if (loader::kFileMayGo) remove_folder(std::exchange(image.folder_, {}));
  return image;
}

LibraryImage::LibraryImage(LibraryImage&& o) noexcept {
  *this = std::move(o);
}

LibraryImage& LibraryImage::operator=(LibraryImage&& o) noexcept {
  if (this != &o) {
    close();
    handle_ = std::exchange(o.handle_, nullptr);
    folder_ = std::exchange(o.folder_, {});
  }
  return *this;
}

LibraryImage::~LibraryImage() {
  close();
}

void* LibraryImage::symbol(const char* name) const noexcept {
  return handle_ != nullptr ? loader::symbol(handle_, name) : nullptr;
}

void LibraryImage::close() noexcept {
  if (handle_ != nullptr) loader::unload(handle_);
  handle_ = nullptr;
  remove_folder(std::exchange(folder_, {}));
}

}  // namespace lac
