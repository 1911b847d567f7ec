// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace lac {

/// Fast 64-bit hash (not cryptographic). Each 8 bytes are mixed by themselves, with their position,
/// and added up, so that the processor works on all of them at once.
inline std::uint64_t hash_of_text(std::string_view s) noexcept {
  constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ull;
  std::uint64_t key = kStep, sum = s.size();
  const auto add = [&](std::uint64_t word) {
    std::uint64_t x = (word ^ key) * 0xff51afd7ed558ccdull;
    x ^= x >> 32;
    sum += x * 0xc4ceb9fe1a85ec53ull;
    key += kStep;
  };
  const auto word_at = [&](std::size_t at) {
    std::uint64_t word;
    std::memcpy(&word, s.data() + at, sizeof word);  // of known size: one load, not a call
    return word;
  };
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  for (std::size_t at = 0; at + kWord <= s.size(); at += kWord) add(word_at(at));
  if (s.size() >= kWord) {
    add(word_at(s.size() - kWord));  // the rest together with what stands before it
  } else {
    std::uint64_t rest = 0;
    for (const char c : s) rest = (rest << 8) | static_cast<unsigned char>(c);
    add(rest);
  }
  sum ^= sum >> 29;
  sum *= 0xbf58476d1ce4e5b9ull;
  return sum ^ (sum >> 32);
}

}  // namespace lac
