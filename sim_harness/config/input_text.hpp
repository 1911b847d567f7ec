// SPDX-License-Identifier: Apache-2.0
// Input files of controllers as text that is written anew.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lac::sim {

/// The key of one line of a controller's input file, as it stands there: the first word behind the
/// '!' of a line with a value; empty for comments and blank lines. For files that are written anew
/// line by line; core/input_file.hpp reads them.
std::string key_of_input_line(std::string_view line);

/// Throws lac::Error if it cannot be read.
std::string text_of_file(const std::filesystem::path& path);

/// The file a text was made from may hold what somebody tuned by hand. Throws lac::Error if `path`
/// is that file; `what` it is, for the message: "the template of the design".
void require_other_file(const std::filesystem::path& path, const std::filesystem::path& made_from,
                        const std::string& what);

}  // namespace lac::sim
