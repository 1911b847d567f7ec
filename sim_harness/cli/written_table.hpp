// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace lac::sim {

/// Writes a table as a whole or not at all and says so; an empty path: nothing. Throws lac::Error.
void write_table(const std::filesystem::path& file, const std::string& text, std::ostream& out);

}  // namespace lac::sim
