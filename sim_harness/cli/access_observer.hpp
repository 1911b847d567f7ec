// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace lac::sim {

/// A float array that sees who touches it: while watched, its memory is protected, each access
/// traps, is noted and let through by a single step of the processor. Works with any library that
/// touches the array by instructions of its own and changes nothing for it but its speed.
///
/// What it cannot do: a system call on the array (read() straight into it) is not seen and fails
/// with EFAULT; an instruction that reads one record and writes another (rep movs within the
/// array) is noted as the one that the processor reports first. Linux on x86-64; one watched
/// array at a time, one thread.
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

  /// While it lives, what happens to the array is noted in `into` (entries 0 ... size); however
  /// its scope is left, the array is free again and the signal handlers are those of before.
  /// Without available() only the writes that changed something.
  class Watch {
   public:
    Watch(ObservedArray& array, Accesses& into) : array_(array) { array_.begin(into); }
    ~Watch() { array_.end(); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    ObservedArray& array_;
  };

 private:
  void begin(Accesses& into);
  void end() noexcept;

  int size_;
  std::size_t bytes_ = 0;
  float* data_ = nullptr;
  Accesses* accesses_ = nullptr;
  std::vector<float> before_;
};

}  // namespace lac::sim
