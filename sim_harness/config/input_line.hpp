// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace lac::sim {

/// The key of one line of a controller's input file, as it stands there: the first word behind the
/// '!' of a line with a value; empty for comments and blank lines. For files that are written anew
/// line by line; core/input_file.hpp reads them.
std::string key_of_input_line(std::string_view line);

}  // namespace lac::sim
