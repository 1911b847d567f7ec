// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace lac::sim {

/// A float array that sees who touches it: while watched, its memory is protected, each access
/// traps, is noted and let through by a single step of the processor. Works with any library and
/// changes nothing for it but its speed. Linux on x86-64; one watched array at a time, one thread.
class ObservedArray {
 public:
  /// Records are counted from 1.
  struct Accesses {
    std::vector<bool> read;
    std::vector<bool> written;
  };

  static bool available();

  /// All zero. Throws lac::Error if the memory cannot be had.
  explicit ObservedArray(int size);
  ~ObservedArray();
  ObservedArray(const ObservedArray&) = delete;
  ObservedArray& operator=(const ObservedArray&) = delete;

  float* data() { return data_; }
  int size() const { return size_; }

  /// Notes what happens between the two calls in `into` (entries 0 ... size). Without
  /// available() only the writes that changed something.
  void watch(Accesses& into);
  void stop();

 private:
  int size_;
  std::size_t bytes_ = 0;
  float* data_ = nullptr;
  Accesses* accesses_ = nullptr;
  std::vector<float> before_;
};

}  // namespace lac::sim
