// SPDX-License-Identifier: Apache-2.0
// Controllers that cannot be loaded: start-up code that aborts (ABORTS) or throws.
#include <cstdlib>
#include <stdexcept>

#include "core/discon_abi.h"

namespace {

struct StartUp {
  StartUp() {
#if defined(ABORTS)
    std::abort();
#else
    throw std::runtime_error("start-up code of a toy");
#endif
  }
};
const StartUp start_up;

}  // namespace

extern "C" LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float*, int*, const char*, char*, char*) {}
