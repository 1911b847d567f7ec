// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/discon_abi.h"
#include "core/swap_layout.hpp"

namespace lac::test {

/// The host's side of DISCON calls, strict: the array is exactly as long as it says (so that an
/// address sanitizer sees one record too far), strings are rebuilt for each call and the message
/// buffer has exactly record 49 characters.
class TestHost {
 public:
  explicit TestHost(LacDisconFunction entry, std::string in_file,
                    std::string out_name = "case.SrvD", int array_size = kExtendedArraySize)
      : array(static_cast<std::size_t>(array_size)),
        in_file_(std::move(in_file)),
        out_name_(std::move(out_name)),
        entry_(entry) {
    set(Rec::TimeStep, 0.0125f);
    set(Rec::GeneratorSpeed, 122.9f);
    set(Rec::RotorSpeed, 1.267f);
    set(Rec::NumberOfBlades, 3.0f);
    set(Rec::HubWindSpeed, 18.0f);
    if (array_size > kHostBlock.last()) {
      set(Rec::ExtendedStart, kExtendedSignature);
      set(Rec::ArraySize, static_cast<float>(array_size));
    }
  }

  TestHost(const TestHost&) = delete;
  TestHost& operator=(const TestHost&) = delete;
  /// Ends a run that the test left open.
  ~TestHost() {
    if (running_) call(LAC_STATUS_LAST);
  }

  /// One call; status 1 advances record 2. Gives aviFAIL; the text is in message().
  int call(int status) { return call_with(status, in_file_); }

  int call_with(int status, const std::string& in_file) {
    if (status == LAC_STATUS_FIRST) steps_ = 0;
    if (status == LAC_STATUS_STEP) ++steps_;
    set(Rec::Status, static_cast<float>(status));
    set(Rec::Time, static_cast<float>(steps_ * static_cast<double>(get(Rec::TimeStep))));
    set(Rec::MessageCapacity, static_cast<float>(message_capacity));
    set(Rec::InFileLength, static_cast<float>(in_file.size() + (counts_terminator ? 1 : 0)));
    set(Rec::OutNameLength, static_cast<float>(out_name_.size() + (counts_terminator ? 1 : 0)));
    std::vector<char> in = text_buffer(in_file);
    std::vector<char> out = text_buffer(out_name_);
    std::vector<char> message(message_capacity, '#');
    int fail = 0;
    entry_(array.data(), &fail, in.data(), out.data(), message.data());
    const auto end = std::find(message.begin(), message.end(), '\0');
    running_ = status == LAC_STATUS_LAST ? false : running_ || fail >= 0;
    terminated_ = end != message.end() || message_capacity == 0;
    message_.assign(message.begin(), end != message.end() ? end : message.begin());
    return fail;
  }

  float get(Rec r) const { return array[static_cast<std::size_t>(r) - 1]; }
  void set(Rec r, float value) { array[static_cast<std::size_t>(r) - 1] = value; }
  float at(int record) const { return array[static_cast<std::size_t>(record) - 1]; }
  void put(int record, float value) { array[static_cast<std::size_t>(record) - 1] = value; }

  const std::string& message() const { return message_; }
  bool message_was_terminated() const { return terminated_; }

  std::vector<float> array;
  std::size_t message_capacity = 1025;
  bool counts_terminator = true;  // OpenFAST; false: Bladed, which may send none at all

 private:
  std::vector<char> text_buffer(const std::string& text) const {
    std::vector<char> buffer(text.begin(), text.end());
    if (counts_terminator) buffer.push_back('\0');
    return buffer;
  }

  std::string in_file_;
  std::string out_name_;
  LacDisconFunction entry_;
  std::string message_;
  bool terminated_ = true;
  bool running_ = false;
  long steps_ = 0;
};

}  // namespace lac::test
