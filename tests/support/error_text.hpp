// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "core/error.hpp"

namespace lac::test {

/// The text of the lac::Error that an action throws, or "no error".
template <class Action>
std::string error_text(Action&& action) {
  try {
    std::forward<Action>(action)();
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace lac::test
