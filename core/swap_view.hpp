// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>

#include "core/swap_layout.hpp"

namespace lac {

/// How many records of a host's array may be touched. Record 66 = 1001 is the signature of an
/// extended array, whose length stands in record 129; everywhere else record 129 is a free user
/// variable and 164 records are what every host is known to have.
inline int known_array_size(const float* swap) {
  const float signature = swap[static_cast<int>(Rec::ExtendedStart) - 1];
  const float size = swap[static_cast<int>(Rec::ArraySize) - 1];
  if (signature == static_cast<float>(kExtendedSignature) && size >= kHostBlock.last() &&
      size <= 1.0e6f) {
    return static_cast<int>(size);
  }
  return kHostBlock.last();
}

/// Typed, read-only view on a float array: with SwapView the only place that knows that records
/// are counted from 1. Does not own the array; valid for one call.
class SwapReader {
 public:
  SwapReader(const float* data, int size) : data_(data), size_(size) {}

  int size() const { return size_; }
  bool holds(const RecordBlock& block) const { return block.last() <= size_; }
  bool holds(int record) const { return record >= 1 && record <= size_; }

  double get(Rec record) const { return at(static_cast<int>(record)); }

  /// By number, counted from 1. Precondition: holds(record).
  double at(int record) const {
    assert(holds(record));
    return static_cast<double>(data_[record - 1]);
  }

  /// Nearest integer; a value that is no number or out of reach gives the fallback.
  int integer(int record, int fallback) const {
    const double v = at(record);
    if (!(v > -1.0e9 && v < 1.0e9)) return fallback;
    return static_cast<int>(v < 0.0 ? v - 0.5 : v + 0.5);  // exact for a float; no library call
  }
  int integer(Rec record, int fallback) const {
    return integer(static_cast<int>(record), fallback);
  }

  const float* data() const { return data_; }

 private:
  const float* data_;
  int size_;
};

/// The same with writing.
class SwapView : public SwapReader {
 public:
  SwapView(float* data, int size) : SwapReader(data, size), writable_(data) {}

  void set(Rec record, double value) { put(static_cast<int>(record), value); }

  /// By number, counted from 1. Precondition: holds(record).
  void put(int record, double value) {
    assert(holds(record));
    writable_[record - 1] = static_cast<float>(value);
  }

  float* data() { return writable_; }

 private:
  float* writable_;
};

}  // namespace lac
