// SPDX-License-Identifier: Apache-2.0
#include "wrapper/secondary.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>

#include "core/call_strings.hpp"
#include "core/error.hpp"
#include "core/native_path.hpp"

namespace lac {
namespace {

constexpr std::array<char, 8> kGuard{'\x5a', '\x11', '\x77', '\x3c',
                                     '\x5a', '\x11', '\x77', '\x3c'};

/// An exception of a secondary is raised by its own C++ runtime and caught by ours, whose tables
/// are empty until it has seen an exception itself; without them it ends the process.
void prepare_to_catch() {
  try {
    throw 0;
  } catch (int) {
  }
}

/// Images of one library share the run-time library of its language, and with it the table of open
/// files of a Fortran program: where they open and close files, one comes after the other.
std::unique_lock<std::recursive_mutex> alone_if(bool needed) {
  static std::recursive_mutex one_at_a_time;
  return needed ? std::unique_lock(one_at_a_time) : std::unique_lock<std::recursive_mutex>();
}

bool is_step(int status) {
  return status == LAC_STATUS_STEP || status == LAC_STATUS_STORE || status == LAC_STATUS_RESTORE;
}

}  // namespace

LentBuffer::LentBuffer(std::size_t capacity)
    : capacity_(capacity), bytes_(capacity + kGuard.size()) {
  restore_guard();
}

void LentBuffer::set(std::string_view text) noexcept {
  const std::size_t n = std::min(text.size(), capacity_ - 1);
  std::memcpy(bytes_.data(), text.data(), n);
  std::memset(bytes_.data() + n, 0, capacity_ - n);
}

void LentBuffer::clear_if_used() noexcept {
  if (bytes_[0] == '\0') return;
  const bool was_filled = bytes_[capacity_ - 2] != '\0';
  if (was_filled && filled_before_) {
    bytes_[0] = '\0';
  } else {
    std::memset(bytes_.data(), 0, capacity_);
  }
  filled_before_ = was_filled;
}

bool LentBuffer::holds(std::string_view text) const noexcept {
  return text.size() < capacity_ && bytes_[text.size()] == '\0' &&
         std::memcmp(bytes_.data(), text.data(), text.size()) == 0;
}

bool LentBuffer::guard_intact() const noexcept {
  return std::memcmp(bytes_.data() + capacity_, kGuard.data(), kGuard.size()) == 0;
}

void LentBuffer::restore_guard() noexcept {
  std::memcpy(bytes_.data() + capacity_, kGuard.data(), kGuard.size());
}

Secondary::Secondary(const WrapperParams& params, const SecondaryParams& secondary,
                     const std::filesystem::path& wrapper_folder, const std::string& host_out_name)
    : library_(params.open_library(secondary, wrapper_folder,
                                   path_from_bytes(host_out_name).parent_path())),
      name_(secondary.name),
      guo_(secondary.guo),
      label_(secondary.name + " (" + library_.path().filename().string() + ")"),
      in_file_(bytes_from_path(secondary.input_file)),
      out_root_(without_host_suffix(host_out_name) + "." + name_ + ".SrvD"),
      in_buffer_(in_file_.size() + 8) {
  prepare_to_catch();
  if (out_root_.size() >= kOutNameCapacity) {
    throw Error("root name of the run is too long: " + std::to_string(out_root_.size()) +
                " characters with the name of " + name_ + ", expected fewer than " +
                std::to_string(kOutNameCapacity));
  }
  in_buffer_.set(in_file_);
  out_buffer_.set(out_root_);
}

void Secondary::call(PrivateArray& array, int status, int log_start, bool logging) noexcept {
  call_as(array, status, in_file_, in_buffer_.data(), log_start, logging);
}

void Secondary::call_with_file(PrivateArray& array, int status, const std::filesystem::path& file,
                               int log_start, bool logging) {
  const std::string name = bytes_from_path(file);
  LentBuffer buffer(name.size() + 8);
  buffer.set(name);
  call_as(array, status, name, buffer.data(), log_start, logging);
}

void Secondary::call_as(PrivateArray& array, int status, std::string_view in_file, char* in_buffer,
                        int log_start, bool logging) noexcept {
  SwapView view = array.view();
  view.set(Rec::Status, status);
  view.set(Rec::MessageCapacity, kMessageCapacity);
  view.set(Rec::InFileLength, static_cast<double>(in_file.size() + 1));
  view.set(Rec::OutNameLength, static_cast<double>(out_root_.size() + 1));
  view.set(Rec::LogCapacity, logging ? kPrivateLogBlock.size : 0);
  view.set(Rec::LogStart, log_start);
  view.set(Rec::OutNameCapacity, logging ? static_cast<double>(kOutNameCapacity) : 0.0);
  view.set(Rec::LogCount, 0.0);
  view.set(Rec::ExtendedStart, kExtendedSignature);
  view.set(Rec::ArraySize, kPrivateArraySize);

  message_.clear_if_used();
  if (!out_buffer_.holds(out_root_)) out_buffer_.set(out_root_);
  fail_ = 0;
  message_text_ = {};
  const auto alone = alone_if(!is_step(status) && library_.has_own_image());
  try {
    library_.entry()(view.data(), &fail_, in_buffer, out_buffer_.data(), message_.data());
  } catch (...) {
    fail_ = -1;
    message_text_ = "the library threw a C++ exception";
  }
  if (fail_ != 0 && message_text_.empty()) message_text_ = read_message(in_file);
  check_guards(array);
}

void Secondary::tell_failure(Notice& notice) const noexcept {
  notice.fail("%s: %.*s", label_.c_str(), static_cast<int>(message_text_.size()),
              message_text_.data());
}

void Secondary::tell_warning(Notice& notice) const noexcept {
  notice.warn("%s: %.*s", label_.c_str(), static_cast<int>(message_text_.size()),
              message_text_.data());
}

void Secondary::check_guards(PrivateArray& array) noexcept {
  const bool array_intact = array.guards_intact();
  if (array_intact && message_.guard_intact() && out_buffer_.guard_intact()) return;
  fail_ = -1;
  message_text_ = !array_intact ? "the library wrote outside of the swap array"
                  : !message_.guard_intact()
                      ? "the library wrote behind the end of the message buffer (record 49)"
                      : "the library wrote behind the end of the root name (record 64)";
  array.restore_guards();  // or the next library would be blamed
  message_.restore_guard();
  out_buffer_.restore_guard();
}

std::string_view Secondary::read_message(std::string_view in_file) noexcept {
  char* text = message_.data();
  std::size_t length = read_string(text, kMessageCapacity).size();
  // The counted terminator of a name inside the text: close the gap.
  while (std::string_view(text, length).ends_with(in_file) && length + 1 < kMessageCapacity &&
         text[length] == '\0' && text[length + 1] != '\0') {
    std::memmove(text + length, text + length + 1, kMessageCapacity - length - 1);
    length = read_string(text, kMessageCapacity).size();
  }
  std::string_view all(text, length);
  // Our own libraries begin with their name, which the label says already.
  if (all.starts_with(name_) && all.substr(name_.size()).starts_with(": ")) {
    all.remove_prefix(name_.size() + 2);
  }
  const std::size_t last = all.find_last_not_of(" \r\n\t");
  return last == std::string_view::npos ? "(no text)" : all.substr(0, last + 1);
}

}  // namespace lac
