// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/discon_abi.h"
#include "core/swap_view.hpp"
#include "tools/host_probe/host_trace.hpp"

namespace lac::test {

/// Makes the calls of a recorded host to one of our libraries: arrays, lengths and buffers are
/// those of the host, to the last float and character, so that a sanitizer sees one too far. Only
/// the names are of this machine: the library's input file, the root name, and the folder of
/// checkpoints.
class TraceReplay {
 public:
  TraceReplay(LacDisconFunction entry, std::string in_file, std::string out_name)
      : entry_(entry), in_file_(std::move(in_file)), out_name_(std::move(out_name)) {}

  static std::vector<TraceCall> read(const std::filesystem::path& file) {
    TraceReader trace(file);
    std::vector<TraceCall> all(1);
    while (trace.next(all.back())) all.emplace_back();
    all.pop_back();
    return all;
  }

  /// Plays one call; gives the array as the library left it, with the host's own records 50 and 51.
  const std::vector<float>& play(const TraceCall& call) {
    array_ = call.sent;
    SwapView swap(array_.data(), static_cast<int>(array_.size()));
    const int status = swap.integer(Rec::Status, 0);
    const bool checkpoint = status == LAC_STATUS_CHECKPOINT || status == LAC_STATUS_RESTART;
    const std::string in_name = checkpoint ? checkpoint_of(call.in_file) : in_file_;
    std::vector<char> in = text(swap, Rec::InFileLength, call.in_file, in_name);
    std::vector<char> out = text(swap, Rec::OutNameLength, call.out_name, out_name_);
    std::vector<char> message(static_cast<std::size_t>(swap.integer(Rec::MessageCapacity, 0)));
    fail_ = call.fail_before;
    entry_(array_.data(), &fail_, in.data(), out.data(), message.data());
    message_.assign(message.begin(), std::find(message.begin(), message.end(), '\0'));
    for (const Rec length : {Rec::InFileLength, Rec::OutNameLength}) {
      const auto i = static_cast<std::size_t>(length) - 1;
      array_[i] = call.sent[i];
    }
    return array_;
  }

  int fail() const { return fail_; }
  const std::string& message() const { return message_; }

 private:
  std::string checkpoint_of(const std::string& recorded) const {
    const auto name = std::filesystem::path(recorded).filename();
    return (std::filesystem::path(out_name_).parent_path() / name).string();
  }

  /// A buffer with the terminator if the host counted it, else without.
  static std::vector<char> text(SwapView& swap, Rec length, const std::string& recorded,
                                const std::string& own) {
    const auto counted = swap.get(length) - static_cast<double>(recorded.size());
    swap.set(length, static_cast<double>(own.size()) + counted);
    std::vector<char> buffer(own.begin(), own.end());
    if (counted > 0.0) buffer.push_back('\0');
    return buffer;
  }

  LacDisconFunction entry_;
  std::string in_file_, out_name_, message_;
  std::vector<float> array_;
  int fail_ = 0;
};

}  // namespace lac::test
