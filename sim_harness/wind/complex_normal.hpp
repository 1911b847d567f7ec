// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>

namespace lac::sim {

/// Independent complex normal numbers, E|xi|^2 = 1 (real and imaginary part 1/2 each), the same on
/// every standard library: xoshiro256++ (Blackman and Vigna 2021), its state filled with splitmix64
/// from the seed and two stream numbers, and Marsaglia's polar method.
class ComplexNormal {
 public:
  ComplexNormal(std::uint64_t seed, std::uint64_t stream, std::uint64_t substream) {
    std::uint64_t mix = scramble(scramble(scramble(seed) + stream) + substream);
    for (std::uint64_t& word : state_) word = scramble(mix += 0x9e3779b97f4a7c15u);
  }

  std::complex<double> operator()() {
    double x, y, s;
    do {
      x = uniform();
      y = uniform();
      s = x * x + y * y;
    } while (s >= 1.0 || s == 0.0);
    const double scale = std::sqrt(-std::log(s) / s);
    return {scale * x, scale * y};
  }

 private:
  static std::uint64_t scramble(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t bits() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  /// In [-1, 1).
  double uniform() {
    return static_cast<double>(static_cast<std::int64_t>(bits()) >> 11) * 0x1p-52;
  }

  std::uint64_t state_[4];
};

}  // namespace lac::sim
