// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "core/locked_file.hpp"

namespace lac {
namespace {

int as_descriptor(std::intptr_t handle) {
  return static_cast<int>(handle);
}

// Another run may have renamed the file between our open and our lock: then it is no longer ours.
bool still_has_name(int descriptor, const std::filesystem::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

int LockedFile::open(const std::filesystem::path& path) noexcept {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  // A file system without locks (some cluster mounts) cannot tell; that is no reason to refuse.
  const bool in_use = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  int code = in_use || !still_has_name(descriptor, path) ? kInUse : 0;
  if (code == 0 && ::ftruncate(descriptor, 0) != 0) code = errno;
  if (code != 0) {
    ::close(descriptor);
    return code;
  }
  handle_ = descriptor;
  return 0;
}

int LockedFile::write(const void* bytes, std::size_t count) noexcept {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = ::write(as_descriptor(handle_), next, count);
    if (written > 0) {
      next += written;
      count -= static_cast<std::size_t>(written);
    } else if (written < 0 && errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

int LockedFile::read(void* bytes, std::size_t count, std::uint64_t position) const noexcept {
  char* next = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = ::pread(as_descriptor(handle_), next, count, static_cast<off_t>(position));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return got < 0 ? errno : EIO;
    next += got;
    position += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
  return 0;
}

int LockedFile::rename(const std::filesystem::path& from,
                       const std::filesystem::path& to) noexcept {
  return std::rename(from.c_str(), to.c_str()) != 0 ? errno : 0;
}

void LockedFile::discard(const std::filesystem::path& path) noexcept {
  ::unlink(path.c_str());
  close();
}

void LockedFile::close() noexcept {
  if (is_open()) ::close(as_descriptor(handle_));
  handle_ = kNone;
}

}  // namespace lac
