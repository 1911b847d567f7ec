// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/call_strings.hpp"
#include "core/discon_library.hpp"
#include "core/notice.hpp"
#include "core/state_archive.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/private_array.hpp"
#include "wrapper/warning_filter.hpp"

namespace lac {

/// A text buffer lent to a secondary, with a guard behind it.
class LentBuffer {
 public:
  explicit LentBuffer(std::size_t capacity);

  char* data() { return bytes_.data(); }
  const char* data() const { return bytes_.data(); }
  std::size_t capacity() const { return capacity_; }
  void set(std::string_view text) noexcept;  // zero behind it; cut at the capacity
  /// Makes an empty text before a call, all zero. That costs more than a call, so it is not done
  /// if the first byte still is zero, nor, but for this byte, after a library that fills the whole
  /// buffer at every call, as ROSCO does with blanks: nothing of its old text can outlive that.
  void clear_if_used() noexcept;
  bool holds(std::string_view text) const noexcept;
  bool guard_intact() const noexcept;
  void restore_guard() noexcept;

 private:
  std::size_t capacity_;
  bool filled_before_ = false;
  std::vector<char> bytes_;
};

/// One library of the chain with the strings and buffers it is called with.
///
/// Lengths: records 50 and 51 count the terminator, as in OpenFAST, for libraries that take it off
/// again. ROSCO does not and puts the counted NUL into the middle of its error text; message()
/// mends that. The root name is "<root of the host>.<name>.SrvD", so that files of secondaries
/// do not meet; the ending is there because ROSCO cuts its name at the last dot.
class Secondary {
 public:
  static constexpr std::size_t kMessageCapacity = 2049;
  static constexpr std::size_t kOutNameCapacity = kOpenFastOutNameCapacity;

  /// Opens the library; throws lac::Error.
  Secondary(const WrapperParams& params, const SecondaryParams& secondary,
            const std::filesystem::path& wrapper_folder, const std::string& host_out_name);

  /// One call with this secondary's own strings, message buffer and records 49-51 and 62-66; what
  /// came back is then in fail() and message(). Writing over a guard counts as failure.
  /// Real time as far as the library is; only calls that open and close files (first, last,
  /// checkpoint) wait for those of other secondaries of this kind, if the library has an image of
  /// its own. [real time]
  void call(PrivateArray& array, int status, int log_start, bool logging) noexcept;

  /// The same for -8 and -9, which take a file. [not real time]
  void call_with_file(PrivateArray& array, int status, const std::filesystem::path& file,
                      int log_start, bool logging);

  int fail() const { return fail_; }
  std::string_view message() const { return message_text_; }
  /// The message with the label in front.
  void tell_failure(Notice& notice) const noexcept;
  void tell_warning(Notice& notice) const noexcept;

  /// "<name> (<file of the library>)".
  const std::string& label() const { return label_; }
  const std::string& name() const { return name_; }
  bool guo() const { return guo_; }  // record 63 is its lidar block

  bool started = false;  // its first call went well and its last one has not come
  bool member = false;   // one of LAC Chain's own: understands -10 and -11
  WarningFilter filter;

 private:
  void call_as(PrivateArray& array, int status, std::string_view in_file, char* in_buffer,
               int log_start, bool logging) noexcept;
  void check_guards(PrivateArray& array) noexcept;
  std::string_view read_message(std::string_view in_file) noexcept;

  DisconLibrary library_;
  std::string name_;
  bool guo_;
  std::string label_;
  std::string in_file_;
  std::string out_root_;
  LentBuffer in_buffer_;
  LentBuffer out_buffer_{kOutNameCapacity};
  LentBuffer message_{kMessageCapacity};
  int fail_ = 0;
  std::string_view message_text_;
};

}  // namespace lac
