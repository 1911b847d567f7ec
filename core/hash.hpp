// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace lac {

/// Fast 64-bit hash (not cryptographic); chained through `seed`.
inline std::uint64_t hash_of_text(std::string_view s,
                                  std::uint64_t seed = 0x9e3779b97f4a7c15ull) noexcept {
  std::uint64_t hash = seed;
  const auto mix = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * 0xff51afd7ed558ccdull;
    hash ^= hash >> 32;
  };
  const char* p = s.data();
  std::size_t left = s.size();
  for (; left >= sizeof(std::uint64_t); left -= sizeof(std::uint64_t)) {
    std::uint64_t word;
    std::memcpy(&word, p, sizeof word);  // of known size: one load, not a call
    mix(word);
    p += sizeof word;
  }
  if (s.size() >= sizeof(std::uint64_t)) {  // the rest together with what stands before it
    std::uint64_t word;
    std::memcpy(&word, s.data() + s.size() - sizeof word, sizeof word);
    mix(word);
  } else {
    std::uint64_t rest = 0;
    for (; left > 0; --left) rest = (rest << 8) | static_cast<unsigned char>(*p++);
    mix(rest);
  }
  hash = (hash ^ s.size()) * 0xc4ceb9fe1a85ec53ull;
  return hash ^ (hash >> 29);
}

}  // namespace lac
