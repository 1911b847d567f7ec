// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#if defined(_WIN32)
#define LAC_LIBRARY_SUFFIX ".dll"
#else
#define LAC_LIBRARY_SUFFIX ".so"
#endif

namespace lac::test {

/// One of our libraries as built: "wrapper", "ldp", ...
inline std::string built_library(const std::string& name) {
  return std::string(LAC_LIBRARY_DIR) + "/liblac_" + name + LAC_LIBRARY_SUFFIX;
}

}  // namespace lac::test
