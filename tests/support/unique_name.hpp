// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>

namespace lac::test {

/// "lac_<16 hexadecimal digits>", unlike any other's, also of a test that runs at the same time.
inline std::string unique_name() {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::random_device random;
  std::string name = "lac_";
  for (int i = 0; i < 16; ++i) name += kDigits[random() % 16];
  return name;
}

}  // namespace lac::test
