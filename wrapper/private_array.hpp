// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "core/state_archive.hpp"
#include "core/swap_view.hpp"

namespace lac {

/// The array the secondaries share: kPrivateArraySize records with a guard of kGuard floats
/// before and behind that nobody may write to.
class PrivateArray {
 public:
  static constexpr std::size_t kGuard = 16;

  PrivateArray() { restore_guards(); }

  SwapView view() { return {storage_.data() + kGuard, kPrivateArraySize}; }
  float* record(int index) { return storage_.data() + kGuard + index - 1; }

  // Bytes are compared, not numbers: a guard counts as intact only if no bit of it was touched.
  bool guards_intact() const noexcept {
    return (touched(storage_.data()) | touched(storage_.data() + kBehind)) == 0;
  }
  void restore_guards() noexcept {
    std::memcpy(storage_.data(), kPattern.data(), sizeof kPattern);
    std::memcpy(storage_.data() + kBehind, kPattern.data(), sizeof kPattern);
  }

  void visit(StateArchive& a) { a(storage_); }

 private:
  static constexpr std::size_t kBehind = kGuard + kPrivateArraySize;
  static constexpr std::uint32_t kMark = 0xa5c0ffeeu;  // about -3.3e-16: no value of a controller
  static constexpr auto kPattern = [] {
    std::array<std::uint32_t, kGuard> p{};
    p.fill(kMark);
    return p;
  }();

  /// The bits that differ, or-ed.
  static std::uint32_t touched(const float* guard) noexcept {
    std::array<std::uint32_t, kGuard> found;
    std::memcpy(found.data(), guard, sizeof found);
    std::uint32_t bits = 0;
    for (const std::uint32_t word : found) bits |= word ^ kMark;
    return bits;
  }

  std::array<float, kBehind + kGuard> storage_{};
};

}  // namespace lac
