// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace lac {

/// What start-up code throws: an input, a file or a library is not usable. The text is for the
/// user and complete: file, line, key, what was found, what was expected, a hint. Never thrown
/// in a controller step; never crosses the C boundary (discon_entry.cpp catches everything).
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lac
