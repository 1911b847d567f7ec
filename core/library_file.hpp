// SPDX-License-Identifier: Apache-2.0
// What can be said of a library file without loading it.
#pragma once

#include <filesystem>
#include <string>

namespace lac {

/// Does the file lack some of what its headers speak of? The loader of Linux maps it without
/// asking, and a process that touches a page behind the end of a cut-off file dies (SIGBUS); that
/// of Windows refuses it without saying why. For what is no library of this system, false: the
/// loader says it.
bool is_cut_off(const std::filesystem::path& file);

/// What kind of file it is, for the message when it cannot be loaded: "a 32-bit library for x86;
/// this process is 64-bit x86-64", "a 64-bit Windows library for x86-64; ...", "not a library for
/// this system". Empty if it is one for this process.
std::string describe_library(const std::filesystem::path& file);

}  // namespace lac
