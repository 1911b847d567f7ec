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
  // NOLINTBEGIN(bugprone-suspicious-memory-comparison)
  bool guards_intact() const noexcept {
    return std::memcmp(storage_.data(), kPattern.data(), sizeof kPattern) == 0 &&
           std::memcmp(storage_.data() + kBehind, kPattern.data(), sizeof kPattern) == 0;
  }
  // NOLINTEND(bugprone-suspicious-memory-comparison)
  void restore_guards() noexcept {
    std::memcpy(storage_.data(), kPattern.data(), sizeof kPattern);
    std::memcpy(storage_.data() + kBehind, kPattern.data(), sizeof kPattern);
  }

  void visit(StateArchive& a) { a(storage_); }

 private:
  static constexpr std::size_t kBehind = kGuard + kPrivateArraySize;
  static constexpr auto kPattern = [] {
    std::array<std::uint32_t, kGuard> p{};
    p.fill(0xa5c0ffeeu);  // about -3.3e-16: no value a controller writes
    return p;
  }();

  std::array<float, kBehind + kGuard> storage_{};
};

}  // namespace lac
