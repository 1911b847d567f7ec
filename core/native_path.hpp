// SPDX-License-Identifier: Apache-2.0
// File names as bytes (DISCON strings, text of input files) and as paths.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lac {

/// The path that a host or an input file means by these bytes. Linux and others: the bytes
/// themselves. Windows: UTF-8 if they are valid UTF-8 (our input files are), else the ANSI code
/// page, in which hosts there pass the bytes of their own input files.
std::filesystem::path path_from_bytes(std::string_view bytes);

/// The bytes under which a library finds the file, ours or another's: on Windows the ANSI code
/// page, or UTF-8 for a name that has no place in it or would be read as another one (only
/// libraries that know UTF-8, such as ours, then find the file). Elsewhere the bytes of the path.
/// Messages use path.string() instead, which is UTF-8 on Windows.
std::string bytes_from_path(const std::filesystem::path& path);

}  // namespace lac
