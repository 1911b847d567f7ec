// SPDX-License-Identifier: Apache-2.0
#include "core/part_file.hpp"

#include <string>
#include <system_error>

#include "core/error.hpp"
#include "core/system_reason.hpp"

namespace lac {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what,
                       const std::string& reason) {
  throw Error(file.string() + ": " + what + ": " + reason);
}

}  // namespace

PartFile::PartFile(std::filesystem::path target, const char* suffix)
    : target_(std::move(target)), part_(target_) {
  part_ += suffix;
  std::error_code ignored;
  if (std::filesystem::is_directory(target_, ignored)) {
    fail(target_, "cannot create this file",
         std::make_error_code(std::errc::is_a_directory).message());
  }
  const int code = file_.open(part_);
  if (code == LockedFile::kInUse) {
    throw Error(target_.string() + ": another run is writing this file (" + part_.string() +
                " is locked): give each run its own output file");
  }
  if (code != 0) fail(target_, "cannot create this file", system_reason(code));
}

PartFile::~PartFile() {
  if (file_.is_open()) file_.discard(part_);
}

bool PartFile::write(const void* bytes, std::size_t count) noexcept {
  if (first_error_ == 0) first_error_ = file_.write(bytes, count);
  return first_error_ == 0;
}

void PartFile::read(void* bytes, std::size_t count, std::uint64_t position) const {
  const int code = file_.read(bytes, count, position);
  if (code != 0) fail(part_, "cannot read back what was written", system_reason(code));
}

void PartFile::commit() {
  if (first_error_ != 0) fail(target_, "cannot write this file", system_reason(first_error_));
  if (const int code = file_.rename(part_, target_); code != 0) {
    fail(target_, "cannot rename " + part_.string() + " to this name", system_reason(code));
  }
  file_.close();
}

void write_whole_file(const std::filesystem::path& target, std::string_view bytes) {
  PartFile file(target);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

}  // namespace lac
