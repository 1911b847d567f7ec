// SPDX-License-Identifier: Apache-2.0
// Input files of Guo's chain as text of our own form. A key that ours needs and theirs does not
// have stands as a comment line that says what to fill in; loading the text then reports it.
// Preconditions: the file is theirs (GuoInputFile::is_theirs). All throw lac::Error.
#pragma once

#include <string>

#include "core/guo_input_file.hpp"

namespace lac::sim {

std::string migrated_ldp(const GuoInputFile& file);
std::string migrated_ffp(const GuoInputFile& file);
std::string migrated_wrapper(const GuoInputFile& file);

}  // namespace lac::sim
