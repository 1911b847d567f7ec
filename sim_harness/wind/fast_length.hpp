// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lac::sim {

/// Next even length with no prime factor above 5, which the FFT is fast at.
inline int fast_even_length(int least) {
  for (int n = least + least % 2;; n += 2) {
    int rest = n;
    for (int prime : {2, 3, 5}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return n;
  }
}

}  // namespace lac::sim
