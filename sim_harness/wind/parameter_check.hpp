// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <sstream>
#include <string_view>

#include "core/error.hpp"

namespace lac::sim {

/// Throws lac::Error "<where>: <name> = <found>, expected <expected>" unless ok.
inline void require(bool ok, std::string_view where, std::string_view name, double found,
                    std::string_view expected) {
  if (ok) return;
  std::ostringstream text;
  text.precision(9);
  text << where << ": " << name << " = " << found << ", expected " << expected;
  throw Error(text.str());
}

/// For lengths, speeds and steps: finite and above zero.
inline void require_positive(std::string_view where, std::string_view name, double found) {
  require(std::isfinite(found) && found > 0.0, where, name, found, "a finite number above 0");
}

}  // namespace lac::sim
