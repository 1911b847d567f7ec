// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <filesystem>
#include <type_traits>
#include <vector>

#include "core/part_file.hpp"

namespace lac::sim {

/// Writes numbers of a binary file one after the other (byte order of this machine). The file gets
/// its name with commit(); nothing half-written stays behind.
class BinaryWriter {
 public:
  /// Throws lac::Error if the file cannot be made.
  explicit BinaryWriter(const std::filesystem::path& file) : file_(file) { block_.reserve(kBlock); }

  template <class T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes(&value, sizeof value);
  }

  void bytes(const void* from, std::size_t count) {
    if (block_.size() + count > kBlock) flush();
    if (count > kBlock) {
      file_.write(from, count);
      return;
    }
    const std::size_t at = block_.size();
    block_.resize(at + count);
    std::memcpy(block_.data() + at, from, count);
  }

  /// Throws lac::Error if anything could not be written.
  void commit() {
    flush();
    file_.commit();
  }

 private:
  static constexpr std::size_t kBlock = 1U << 18U;

  void flush() {
    file_.write(block_.data(), block_.size());  // a failure is kept for commit()
    block_.clear();
  }

  PartFile file_;
  std::vector<char> block_;
};

}  // namespace lac::sim
