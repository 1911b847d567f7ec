// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "core/error.hpp"

namespace lac::sim {

static_assert(std::endian::native == std::endian::little, "wind files are little-endian");

/// Reads numbers of a binary file one after the other (byte order of this machine). Throws
/// lac::Error "<file>: offset <n>: <name>: found <...>, expected <...>" when one is not as it
/// should be; the offset is that of the number.
class BinaryReader {
 public:
  /// kind completes the sentence "expected ... in <kind>".
  BinaryReader(const std::filesystem::path& file, const char* kind)
      : file_(file), kind_(kind), stream_(file, std::ios::binary) {
    std::error_code error;
    size_ = std::filesystem::file_size(file, error);
    if (error || !stream_) throw Error(file.string() + ": cannot be opened for reading");
  }

  template <class T>
  T number(const char* name, T least, T most) {
    T value{};
    bytes(&value, sizeof value, name);
    if (!(value >= least && value <= most)) {
      std::ostringstream expected;
      expected << least << " to " << most << " in " << kind_;
      fail(offset_ - sizeof value, name, value, expected.str());
    }
    return value;
  }

  void bytes(void* to, std::size_t count, const char* name) {
    expect_left(count, name);
    stream_.read(static_cast<char*>(to), static_cast<std::streamsize>(count));
    if (!stream_) fail(offset_, name, "a read error", std::to_string(count) + " bytes");
    offset_ += count;
  }

  void skip(std::size_t count, const char* name) {
    expect_left(count, name);
    stream_.seekg(static_cast<std::streamoff>(count), std::ios::cur);
    offset_ += count;
  }

  /// Bytes that are left.
  std::uint64_t rest() const { return size_ - offset_; }

  /// For numbers read as bytes: the one that ends `bytes_back` before the present offset cannot be.
  template <class T>
  [[noreturn]] void refuse(std::uint64_t bytes_back, const char* name, const T& found,
                           const std::string& expected) const {
    fail(offset_ - bytes_back - sizeof(T), name, found, expected + " in " + kind_);
  }

  /// What follows must be all of the file that is left.
  void expect_rest(const char* name, std::uint64_t count) const {
    if (rest() == count) return;
    fail(offset_, name, std::to_string(rest()) + " bytes",
         std::to_string(count) + " from the sizes in the header; the file is " +
             (rest() < count ? "truncated" : "longer than " + std::string(kind_)));
  }

 private:
  void expect_left(std::size_t count, const char* name) const {
    if (count > rest()) {
      fail(offset_, name, "the end of the file",
           std::to_string(count) + " bytes more; the file is truncated");
    }
  }

  template <class T>
  [[noreturn]] void fail(std::uint64_t offset, const char* name, const T& found,
                         const std::string& expected) const {
    std::ostringstream text;
    text << file_.string() << ": offset " << offset << ": " << name << ": found " << found
         << ", expected " << expected;
    throw Error(text.str());
  }

  std::filesystem::path file_;
  const char* kind_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  std::uint64_t offset_ = 0;
};

}  // namespace lac::sim
