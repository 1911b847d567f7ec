// SPDX-License-Identifier: Apache-2.0
// A series that any language reproduces to the last bit: the numbers of other programs for it
// stand in the tests.
#pragma once

#include <cstdint>
#include <vector>

namespace lac::sim::test {

/// x -> (1103515245 x + 12345) mod 2^31 from 12345; values (x >> 16) mod 1000.
inline std::vector<double> lcg_series(int samples) {
  std::vector<double> series;
  std::uint64_t x = 12345;
  for (int i = 0; i < samples; ++i) {
    x = (1103515245U * x + 12345U) % 2147483648U;
    series.push_back(static_cast<double>((x >> 16) % 1000U));
  }
  return series;
}

}  // namespace lac::sim::test
