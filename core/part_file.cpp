// SPDX-License-Identifier: Apache-2.0
#include "core/part_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "core/error.hpp"

namespace lac {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what, int code) {
  throw Error(file.string() + ": " + what + ": " + std::generic_category().message(code));
}

// Another run may have renamed the file between our open and our lock: then it is no longer ours.
bool still_has_name(int descriptor, const std::filesystem::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

PartFile::PartFile(std::filesystem::path target, const char* suffix)
    : target_(std::move(target)), part_(target_) {
  part_ += suffix;
  std::error_code ignored;
  if (std::filesystem::is_directory(target_, ignored))
    fail(target_, "cannot create this file", EISDIR);
  descriptor_ = ::open(part_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(target_, "cannot create this file", errno);
  // A file system without locks (some cluster mounts) cannot tell; that is no reason to refuse.
  const bool in_use = ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (in_use || !still_has_name(descriptor_, part_)) {
    ::close(descriptor_);
    throw Error(target_.string() + ": another run is writing this file (" + part_.string() +
                " is locked): give each run its own output file");
  }
  if (::ftruncate(descriptor_, 0) != 0) {
    const int code = errno;
    ::close(descriptor_);
    fail(target_, "cannot empty " + part_.string(), code);
  }
}

PartFile::~PartFile() {
  if (descriptor_ < 0) return;
  ::unlink(part_.c_str());
  ::close(descriptor_);
}

bool PartFile::write(const void* bytes, std::size_t count) noexcept {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0 && first_error_ == 0) {
    const ssize_t written = ::write(descriptor_, next, count);
    if (written > 0) {
      next += written;
      count -= static_cast<std::size_t>(written);
    } else if (written < 0 && errno != EINTR) {
      first_error_ = errno;
    }
  }
  return first_error_ == 0;
}

void PartFile::read(void* bytes, std::size_t count, std::uint64_t position) const {
  char* next = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = ::pread(descriptor_, next, count, static_cast<off_t>(position));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail(part_, "cannot read back what was written", got < 0 ? errno : EIO);
    next += got;
    position += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
}

void PartFile::commit() {
  if (first_error_ != 0) fail(target_, "cannot write this file", first_error_);
  if (std::rename(part_.c_str(), target_.c_str()) != 0) {
    fail(target_, "cannot rename " + part_.string() + " to this name", errno);
  }
  ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace lac
